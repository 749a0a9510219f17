package org.jsmesh.codec.entropy;

/** The reading side of {@link RangeEncoder}. It reads zeros past its end, so any bytes decode to something. */
public final class RangeDecoder extends BinaryCoder {
    private final byte[] bytes;
    private final int end;
    private int position;
    private int code;
    private int range = 0x7fffffff;

    public RangeDecoder(byte[] bytes, int offset, int length) {
        this.bytes = bytes;
        position = offset;
        end = offset + length;
        for (int i = 0; i < 4; i++) code = code << 8 | read();
    }

    @Override
    public boolean isEncoder() {
        return false;
    }

    @Override
    public boolean isExhausted() {
        return position > end + 8;
    }

    private int read() {
        int at = position++;
        return at < end ? bytes[at] & 0xff : 0;
    }

    @Override
    int codeBit(int probability, int ignored) {
        int bound = (range >>> PROBABILITY_BITS) * probability;
        int bit;
        if (code < bound) {
            range = bound;
            bit = 1;
        } else {
            code -= bound;
            range -= bound;
            bit = 0;
        }
        while (range < 1 << 23) {
            range <<= 8;
            code = code << 8 | read();
        }
        return bit;
    }

    @Override
    int codeRaw(int ignored, int count) {
        range >>>= count;
        return take((1 << count) - 1);
    }

    @Override
    int codeBelow(int ignored, int bound) {
        range /= bound;
        return take(bound - 1);
    }

    private int take(int largest) {
        int value = code / range;
        if (value > largest) value = largest;
        if (value < 0) value = 0; // only in damaged streams
        code -= range * value;
        while (range < 1 << 23) {
            range <<= 8;
            code = code << 8 | read();
        }
        return value;
    }
}
