package org.jsmesh.mesh.io.zip;

import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import java.util.zip.GZIPInputStream;
import java.util.zip.ZipException;
import org.jsmesh.mesh.Sizes;

/**
 * Unpacks within limits. Bytes may grow to {@code mostBytes} in all, and to 250 times their packed size: models pack to
 * a tenth or, where they are very regular, to a hundredth; only files made to harm pack to less. Not thread-safe.
 */
public final class Unpacker {
    /** Most bytes that one array holds. */
    public static final long MOST_BYTES = Sizes.MOST;

    private static final int MOST_RATIO = 250;
    private static final int SMALL = 1 << 20; // small things harm no one

    private long left;

    /** @param mostBytes in all, over everything that is unpacked */
    public Unpacker(long mostBytes) {
        left = mostBytes;
    }

    /** {@return how many bytes may still be unpacked, by this or by who tells {@link #spend}} */
    public long left() {
        return left;
    }

    /**
     * Counts what somebody else has unpacked.
     *
     * @param bytes of it
     */
    public void spend(long bytes) {
        left = Math.max(0, left - bytes);
    }

    /**
     * Tells whether bytes are packed with gzip.
     *
     * @param content any bytes
     * @return true when they begin as gzip does
     */
    public static boolean isGzip(byte[] content) {
        return content.length >= 18 && content[0] == 0x1F && content[1] == (byte) 0x8B && content[2] == 8;
    }

    /**
     * Unpacks gzip, all members of it.
     *
     * @param content bytes for which {@link #isGzip} holds
     * @return what they hold
     * @throws PackedException when they are damaged, or hold more than allowed
     */
    public byte[] gunzip(byte[] content) throws PackedException {
        try (InputStream in = new GZIPInputStream(new ByteArrayInputStream(content), 1 << 16)) {
            return read(in, content.length, "the gzip file");
        } catch (EOFException e) {
            throw new PackedException("the gzip file is cut off", "Get it again");
        } catch (PackedException e) {
            throw e;
        } catch (IOException e) {
            throw new PackedException("the gzip file is damaged", "Pack it again");
        }
    }

    /**
     * Refuses what unpacks to too much.
     *
     * @param bytes unpacked so far
     * @param packedBytes that they are unpacked from, all of them
     * @param most bytes allowed
     * @param what for the message
     * @throws PackedException when there are more than allowed, or than any model unpacks to
     */
    public static void check(long bytes, long packedBytes, long most, String what) throws PackedException {
        if (bytes > most)
            throw new PackedException(what + " unpacks to more bytes than allowed", "Give a smaller model");
        if (bytes > Math.max(SMALL, MOST_RATIO * packedBytes))
            throw new PackedException(
                    what + " unpacks to more than " + MOST_RATIO + " times its bytes, as only harmful files do",
                    "Unpack it first");
    }

    /**
     * Reads to the end.
     *
     * @param packedBytes that the stream unpacks
     * @param what for messages
     * @throws ZipException or another IOException of the stream, when it is damaged
     */
    byte[] read(InputStream in, long packedBytes, String what) throws IOException {
        long most = Math.min(left, MOST_BYTES - 1);
        byte[] bytes = new byte[(int) Math.min(most, 4 * packedBytes) + 1];
        int size = 0;
        for (int count = in.read(bytes, 0, bytes.length);
                count >= 0;
                count = in.read(bytes, size, bytes.length - size)) {
            size += count;
            check(size, packedBytes, most, what);
            if (size == bytes.length) bytes = Arrays.copyOf(bytes, (int) Math.min(most, 2L * size) + 1);
        }
        left -= size;
        return size == bytes.length ? bytes : Arrays.copyOf(bytes, size);
    }
}
