package org.jsmesh.files;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.concurrent.CancellationException;
import java.util.zip.GZIPInputStream;
import java.util.zip.ZipException;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.io.ByteSource;
import org.jsmesh.mesh.io.zip.PackedException;
import org.jsmesh.mesh.io.zip.Unpacker;

/**
 * What a large gzip file holds, unpacked anew for each reading. It is unpacked once before, to count the bytes and to
 * find damage, since a reader must know how many there are before it makes room for what a header claims.
 */
final class GzipSource implements ByteSource {
    private static final int PORTION = 1 << 16;

    private final ByteSource packed;
    private final long length;

    private GzipSource(ByteSource packed, long length) {
        this.packed = packed;
        this.length = length;
    }

    /**
     * Unpacks all of it once.
     *
     * @param unpacker how much it may hold, with all that was unpacked before
     * @param progress may cancel
     * @throws PackedException when it is damaged, or holds more than allowed
     */
    static GzipSource of(ByteSource packed, Unpacker unpacker, ProgressListener progress) throws IOException {
        try (InputStream raw = packed.from(0);
                InputStream in = new GZIPInputStream(raw, PORTION)) {
            byte[] portion = new byte[PORTION];
            long length = 0;
            for (int count; (count = in.read(portion)) >= 0; ) {
                length += count;
                Unpacker.check(length, packed.length(), unpacker.left(), "the gzip file");
                if (progress.isCancelled()) throw new CancellationException("reading was cancelled");
            }
            unpacker.spend(length);
            raw.transferTo(OutputStream.nullOutputStream()); // what is behind the last member
            return new GzipSource(packed, length);
        } catch (EOFException e) {
            throw new PackedException("the gzip file is cut off", "Get it again");
        } catch (ZipException e) {
            throw new PackedException("the gzip file is damaged", "Pack it again");
        }
    }

    @Override
    public long length() {
        return length;
    }

    @Override
    public InputStream from(long offset) throws IOException {
        InputStream raw = packed.from(0);
        try {
            InputStream in = new GZIPInputStream(raw, PORTION);
            in.skipNBytes(offset);
            return in;
        } catch (Throwable e) {
            raw.close();
            throw e;
        }
    }
}
