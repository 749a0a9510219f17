package org.jsmesh.poster;

import java.io.ByteArrayOutputStream;

/** Bits of the coded blocks, the highest first; a byte of ones is followed by one of zeros (ITU T.81, F.1.2.3). */
final class BitSink {
    private final ByteArrayOutputStream out;
    private int held;
    private int count;

    BitSink(ByteArrayOutputStream out) {
        this.out = out;
    }

    void put(int value, int length) {
        for (int i = length - 1; i >= 0; i--) {
            held = held << 1 | value >> i & 1;
            if (++count == 8) flush();
        }
    }

    private void flush() {
        out.write(held);
        if (held == 0xff) out.write(0);
        held = 0;
        count = 0;
    }

    /** Fills the last byte with ones. */
    void finish() {
        while (count > 0) put(1, 1);
    }
}
