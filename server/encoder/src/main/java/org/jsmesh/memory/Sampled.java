package org.jsmesh.memory;

import java.io.IOException;
import java.nio.charset.StandardCharsets;

/** A file of which parts are read. */
final class Sampled {
    static final int SAMPLES = 64;

    /** As the text of a file begins that has one. */
    static final String BYTE_ORDER_MARK = "\u00ef\u00bb\u00bf";

    private static final int SAMPLE_BYTES = 4096; // of few samples each is larger

    private final String name;
    private final long length;
    private final ByteRanges content;
    private byte[] start;

    Sampled(String name, long length, ByteRanges content) {
        this.name = name;
        this.length = length;
        this.content = content;
    }

    String name() {
        return name;
    }

    long length() {
        return length;
    }

    /** The first bytes, all of a small file. */
    byte[] start() throws IOException {
        if (start == null) start = read(0, MemoryEstimate.START_BYTES);
        return start;
    }

    int samples() {
        return Math.max(2, content.samples());
    }

    byte[] read(long from, int bytes) throws IOException {
        if (from >= length) return new byte[0];
        return content.read(from, (int) Math.min(bytes, length - from));
    }

    /** A 32-bit number at a place in the first bytes, or 0 where there is none. */
    long littleEndian(int at) throws IOException {
        byte[] b = start();
        if (at + 4 > b.length) return 0;
        return (b[at] & 255L) | (b[at + 1] & 255L) << 8 | (b[at + 2] & 255L) << 16 | (b[at + 3] & 255L) << 24;
    }

    boolean startsWith(String text) throws IOException {
        byte[] b = start();
        if (b.length < text.length()) return false;
        for (int i = 0; i < text.length(); i++) if ((b[i] & 255) != text.charAt(i)) return false;
        return true;
    }

    /** What a sample stands for. */
    interface Part {
        /** @param weight bytes of the file for each byte of the text */
        void take(String text, double weight);
    }

    /**
     * Goes through whole lines of text all over the file: all of it where it is small or only its beginning is at hand.
     * Lines end with a line feed, whatever they end with in the file. Returns false when only the beginning is.
     */
    boolean eachSample(long from, Part part) throws IOException {
        long left = length - from;
        if (left <= (long) SAMPLES * SAMPLE_BYTES) {
            byte[] all = read(from, (int) left);
            part.take(text(all, 0), left == 0 ? 0 : (double) left / Math.max(1, all.length));
            return all.length == left;
        }
        int samples = samples();
        int size = SAMPLES * SAMPLE_BYTES / samples;
        double step = (double) left / samples;
        byte[] last = read((long) (from + (samples - .5) * step), size);
        if (last.length == 0) {
            byte[] known = start();
            int at = (int) Math.min(from, known.length);
            String text = text(known, at);
            part.take(text, (double) left / Math.max(1, text.length()));
            return false;
        }
        for (int i = 0; i < samples; i++) {
            byte[] bytes = i == samples - 1 ? last : read((long) (from + i * step + (i == 0 ? 0 : step / 2)), size);
            String text = text(bytes, 0);
            int first = i == 0 ? 0 : text.indexOf('\n') + 1;
            int end = text.lastIndexOf('\n') + 1;
            if (end > first) part.take(text.substring(first, end), step / (end - first));
        }
        return true;
    }

    /** Old programs end lines with a carriage return alone. */
    private static String text(byte[] bytes, int from) {
        return new String(bytes, from, bytes.length - from, StandardCharsets.ISO_8859_1).replace('\r', '\n');
    }
}
