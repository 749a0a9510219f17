package org.jsmesh.codec.exact;

import org.jsmesh.mesh.Channel;

/** Writes numbers as raw values of a type. */
final class RawNumbers {
    private RawNumbers() {}

    /**
     * Puts a number among raw values: rounded to a whole one and kept within the range of the type where that is one of
     * whole numbers.
     *
     * @param index of the component, counted over all
     */
    static void put(int[] values, int index, Channel.Type type, double x) {
        switch (type) {
            case FLOAT32 -> values[index] = Float.floatToIntBits((float) x);
            case FLOAT64 -> {
                long bits = Double.doubleToRawLongBits(x);
                values[2 * index] = (int) bits;
                values[2 * index + 1] = (int) (bits >>> 32);
            }
            case UINT8 -> values[index] = whole(x, 0, 255);
            case INT8 -> values[index] = whole(x, -128, 127);
            case INT16 -> values[index] = whole(x, -32768, 32767);
            case UINT16 -> values[index] = whole(x, 0, 65535);
            case INT32 -> values[index] = whole(x, Integer.MIN_VALUE, Integer.MAX_VALUE);
            case UINT32 -> values[index] = whole(x - 2147483648.0, Integer.MIN_VALUE, Integer.MAX_VALUE) ^ 0x80000000;
        }
    }

    /** The whole number of a type of at most 16 bits that is next to a number. */
    static int whole(double x, Channel.Type type) {
        int[] value = new int[1];
        put(value, 0, type, x);
        return value[0];
    }

    private static int whole(double x, int least, int most) {
        double rounded = Math.floor(x + .5);
        return rounded <= least ? least : rounded >= most ? most : (int) rounded;
    }
}
