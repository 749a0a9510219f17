package org.jsmesh.memory;

import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.util.Locale;
import java.util.zip.GZIPInputStream;
import java.util.zip.Inflater;
import java.util.zip.InflaterInputStream;
import org.jsmesh.mesh.io.ModelFormat;

/** Counts by the beginning of what a gzip file or a ZIP archive holds, and by its unpacked length. */
final class PackedCount {
    private static final int TAIL = 1 << 16;
    private static final int ENTRY = 0x02014b50;
    private static final double LIKELY_RATIO = 4;

    /** Nothing is packed to less by gzip. */
    private static final int MOST_RATIO = 1032;

    /** Bytes of a gzip file beside what is packed: its head and its end, and a part for what cannot be packed. */
    private static final int GZIP_FRAME = 64;

    private static final double LEAST_RATIO = .99;

    /** A gzip file says its length modulo this. */
    private static final long WRAP = 1L << 32;

    /** Bytes of a 3MF model for each triangle: its line, and half of a vertex' line. */
    private static final double THREE_MF_BYTES = 72;

    private PackedCount() {}

    static ModelCount ofGzip(Sampled file, int layers) throws IOException {
        byte[] start = new byte[0];
        double ratio = LIKELY_RATIO;
        try (GzipBeginning in = new GzipBeginning(file.start())) {
            start = beginning(in);
            if (start.length > 0) ratio = start.length / (double) Math.max(1, in.packedBytes());
        } catch (IOException e) {
            // Reading it will tell.
        }
        return inside(ModelFormat.withoutGzip(file.name()), gzipLength(file, start, ratio), start, file, layers);
    }

    private static final class GzipBeginning extends GZIPInputStream {
        private final int length;

        GzipBeginning(byte[] start) throws IOException {
            super(new ByteArrayInputStream(start));
            length = start.length;
        }

        /** Of which all was made that was read so far, be it in several parts. */
        int packedBytes() throws IOException {
            return length - in.available() - inf.getRemaining();
        }
    }

    /**
     * The length that a gzip file says at its end, unless that cannot be: it is that of the last of several parts, and
     * anything may follow it. It is said modulo 4 GiB. Of the lengths that it may mean it is the one that a binary STL
     * file says, too, or that is most like what is packed so at the beginning.
     */
    private static long gzipLength(Sampled file, byte[] start, double ratio) throws IOException {
        byte[] end = file.read(Math.max(0, file.length() - 4), 4);
        long said = end.length == 4 ? number(end, 0, 4) : 0;
        long stl = StlCount.length(start);
        if (stl % WRAP == said && canBe(stl, file)) return stl;
        long length = said + WRAP * Math.max(0, Math.round((ratio * file.length() - said) / WRAP));
        if (!canBe(length, file)) length = (long) (Math.max(ratio, LIKELY_RATIO) * file.length());
        return Math.max(start.length, length);
    }

    private static boolean canBe(long unpacked, Sampled file) {
        return unpacked >= LEAST_RATIO * file.length() - GZIP_FRAME && unpacked <= MOST_RATIO * file.length();
    }

    static ModelCount ofZip(Sampled file, int layers) throws IOException {
        long tailAt = Math.max(0, file.length() - TAIL);
        byte[] tail = file.read(tailAt, TAIL);
        String best = "";
        long bestLength = 0;
        long bestAt = 0;
        long bestPacked = 0;
        boolean stored = false;
        for (int at = 0; at + 46 <= tail.length; at++) {
            if (number(tail, at, 4) != ENTRY) continue;
            int nameBytes = (int) number(tail, at + 28, 2);
            if (at + 46 + nameBytes > tail.length) break;
            String name = new String(tail, at + 46, nameBytes, java.nio.charset.StandardCharsets.UTF_8);
            long length = number(tail, at + 24, 4);
            if (length == WRAP - 1) length = (long) Math.max(length, LIKELY_RATIO * file.length()); // said elsewhere
            if (!isModel(name) || length < bestLength) continue;
            best = name;
            bestLength = length;
            bestPacked = number(tail, at + 20, 4);
            bestAt = number(tail, at + 42, 4);
            stored = number(tail, at + 10, 2) == 0;
        }
        if (best.isEmpty())
            return inside("model.obj", (long) (LIKELY_RATIO * file.length()), new byte[0], file, layers);
        byte[] head = file.read(bestAt, 30);
        byte[] start = new byte[0];
        if (head.length == 30) {
            long data = bestAt + 30 + number(head, 26, 2) + number(head, 28, 2);
            byte[] packed = file.read(data, (int) Math.min(bestPacked, MemoryEstimate.START_BYTES));
            start = stored ? packed : inflated(packed);
        }
        if (best.toLowerCase(Locale.ROOT).endsWith(".model")) return threeMf(bestLength, file);
        return inside(best, bestLength, start, file, layers);
    }

    private static boolean isModel(String name) {
        return name.toLowerCase(Locale.ROOT).endsWith(".model") || ModelFormat.ofName(name) != null;
    }

    private static ModelCount threeMf(long length, Sampled file) {
        double faces = length / THREE_MF_BYTES;
        return new ModelCount(faces, 0, faces / 2, 0, 0, file.length(), length, false, false);
    }

    private static ModelCount inside(String name, long length, byte[] start, Sampled file, int layers)
            throws IOException {
        ModelCount count = ModelCount.of(new Sampled(name, length, ByteRanges.ofStart(start)), layers);
        return count.withPacked(file.length());
    }

    private static byte[] inflated(byte[] packed) {
        try (InputStream in = new InflaterInputStream(new ByteArrayInputStream(packed), new Inflater(true))) {
            return beginning(in);
        } catch (IOException e) {
            return new byte[0];
        }
    }

    /** The first bytes of a stream that may be cut. */
    private static byte[] beginning(InputStream in) throws IOException {
        byte[] start = new byte[MemoryEstimate.START_BYTES];
        int n = 0;
        try {
            for (int read; n < start.length && (read = in.read(start, n, start.length - n)) > 0; ) n += read;
        } catch (EOFException e) {
            // The packed bytes are cut behind this.
        }
        return java.util.Arrays.copyOf(start, n);
    }

    private static long number(byte[] b, int at, int bytes) {
        long n = 0;
        for (int i = 0; i < bytes; i++) n |= (b[at + i] & 255L) << 8 * i;
        return n;
    }
}
