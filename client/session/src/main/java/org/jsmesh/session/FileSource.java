package org.jsmesh.session;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.net.URI;
import java.nio.file.FileSystemNotFoundException;
import java.nio.file.Path;

/** An archive in a local file, behind the same rounds as a remote one. */
final class FileSource implements ArchiveSource {
    private static final int PART_BYTES = 1 << 16;
    private final Path file;
    private final SteadyClock clock;

    FileSource(Path file, SteadyClock clock) {
        this.file = file;
        this.clock = clock;
    }

    /**
     * The file of an address.
     *
     * @throws IllegalArgumentException when it is none of a file
     */
    static Path path(URI location) {
        try {
            return Path.of(location);
        } catch (IllegalArgumentException | FileSystemNotFoundException e) {
            throw new IllegalArgumentException(
                    location + " is no address of a file; write it as file:///folder/model.jsm", e);
        }
    }

    @Override
    public ArchiveBody open(long fromByte, long endByte, String entityTag) {
        return new Body(fromByte, endByte);
    }

    @Override
    public boolean isLocal() {
        return true;
    }

    @Override
    public String name() {
        return file.toString();
    }

    private final class Body implements ArchiveBody {
        private final long fromByte;
        private final long askedEnd;
        private RandomAccessFile in;
        private long at;
        private long end;

        Body(long fromByte, long askedEnd) {
            this.fromByte = fromByte;
            this.askedEnd = askedEnd;
        }

        @Override
        public Part poll(long timeoutMillis) throws IOException {
            if (in == null) return begin();
            if (at >= end) {
                cancel();
                return new End();
            }
            byte[] bytes = new byte[(int) Math.min(PART_BYTES, end - at)];
            in.readFully(bytes);
            at += bytes.length;
            return new Bytes(bytes, bytes.length, clock.millis());
        }

        private Head begin() throws IOException {
            try {
                in = new RandomAccessFile(file.toFile(), "r");
            } catch (IOException e) {
                String what = file.toFile().exists() ? "cannot be read" : "does not exist";
                throw FetchException.lasting(file.toString(), what, "give the path of a .jsm file");
            }
            long length = in.length();
            end = askedEnd < 0 ? length : Math.min(askedEnd, length);
            if (fromByte > length) throw new ArchiveChangedException(file.toString(), "it is shorter than before");
            in.seek(fromByte);
            at = fromByte;
            return new Head(fromByte, end, length, null, true);
        }

        @Override
        public void cancel() {
            if (in == null) return;
            try {
                in.close();
            } catch (IOException e) {
                // Nothing was written; there is nothing to lose.
            }
        }

        @Override
        public String url() {
            return file.toUri().toString();
        }

        @Override
        public String range() {
            return Ranges.header(fromByte, askedEnd);
        }

        @Override
        public boolean isHttp2() {
            return false;
        }
    }
}
