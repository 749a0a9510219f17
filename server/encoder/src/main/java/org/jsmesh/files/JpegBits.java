package org.jsmesh.files;

import java.util.Arrays;

/** The entropy-coded bits of a scan of a JPEG (ITU T.81). */
final class JpegBits {
    private final byte[] file;
    private int at;
    private int current;
    private int left;

    JpegBits(byte[] file, int at) {
        this.file = file;
        this.at = at;
    }

    int next() {
        if (left == 0) {
            current = file[at++] & 255;
            if (current == 255) {
                if (file[at] != 0) throw new IllegalArgumentException("a scan ends early");
                at++;
            }
            left = 8;
        }
        return current >> --left & 1;
    }

    /** A signed number of so many bits (F.2.2.1). */
    int difference(int length) {
        if (length > 11) throw new IllegalArgumentException("a difference of " + length + " bits");
        int value = 0;
        for (int i = 0; i < length; i++) value = value << 1 | next();
        return length > 0 && value < 1 << length - 1 ? value - (1 << length) + 1 : value;
    }

    void restart() {
        left = 0;
        while ((file[at] & 255) != 255 || (file[at + 1] & 0xf8) != 0xd0) at++;
        at += 2;
    }

    /** A Huffman table (annex C). */
    static final class Huffman {
        private final int[] counts = new int[16];
        private final byte[] values;
        final int size;

        Huffman(byte[] file, int at) {
            int sum = 0;
            for (int i = 0; i < 16; i++) sum += counts[i] = file[at + i] & 255;
            size = sum;
            values = Arrays.copyOfRange(file, at + 16, at + 16 + sum);
        }

        int next(JpegBits bits) {
            int code = 0;
            int first = 0;
            int index = 0;
            for (int count : counts) {
                code = code << 1 | bits.next();
                if (code - first < count) return values[index + code - first] & 255;
                index += count;
                first = first + count << 1;
            }
            throw new IllegalArgumentException("a code that no table has");
        }
    }
}
