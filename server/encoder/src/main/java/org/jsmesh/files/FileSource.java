package org.jsmesh.files;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Objects;
import org.jsmesh.mesh.io.ByteSource;

/**
 * The bytes of a file that may be larger than memory. It is opened for each reading, so nothing is to be closed when
 * there are no more; a file that is not any more what it was at first is refused.
 */
final class FileSource implements ByteSource {
    /** Files up to here are read into memory. */
    static final long LARGE = 16 << 20;

    private final Path file;
    private final BasicFileAttributes found;

    private FileSource(Path file, BasicFileAttributes found) {
        this.file = file;
        this.found = found;
    }

    static FileSource of(Path file) throws IOException {
        return new FileSource(file, Files.readAttributes(file, BasicFileAttributes.class));
    }

    /** Whether a file is not to be read into memory. Pipes and the like do not tell how long they are. */
    static boolean isFor(Path file) throws IOException {
        return Files.isRegularFile(file) && Files.size(file) > LARGE;
    }

    @Override
    public long length() {
        return found.size();
    }

    @Override
    public InputStream from(long offset) throws IOException {
        FileChannel channel = FileChannel.open(file);
        try {
            check();
            return new Unchanged(Channels.newInputStream(channel.position(offset)));
        } catch (Throwable e) {
            channel.close();
            throw e;
        }
    }

    private void check() throws IOException {
        BasicFileAttributes now = Files.readAttributes(file, BasicFileAttributes.class);
        boolean same = now.size() == found.size()
                && now.lastModifiedTime().equals(found.lastModifiedTime())
                && Objects.equals(now.fileKey(), found.fileKey());
        if (!same)
            throw new FileSystemException(
                    file.toString(), null, "was changed while it was read. Try again when it is whole");
    }

    /** Looks at the file again when all of it is read: what was read before it changed would make a mesh of two. */
    private final class Unchanged extends FilterInputStream {
        Unchanged(InputStream in) {
            super(in);
        }

        @Override
        public int read() throws IOException {
            int value = super.read();
            if (value < 0) check();
            return value;
        }

        @Override
        public int read(byte[] bytes, int from, int length) throws IOException {
            int count = super.read(bytes, from, length);
            if (count < 0) check();
            return count;
        }
    }
}
