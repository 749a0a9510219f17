package org.jsmesh.files.gltf.packed;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * What is done to decoded attributes (KHR_meshopt_compression, appendix B), in place. Values outside of what the
 * specification allows give results without meaning.
 */
enum MeshoptFilter {
    NONE {
        @Override
        boolean takes(int stride) {
            return true;
        }

        @Override
        void apply(Components values) {}
    },

    /** Unit vectors on an octahedron; the third component is 1 in the precision of the first two. */
    OCTAHEDRAL {
        @Override
        void apply(Components values) {
            int most = values.mostSigned();
            for (int i = 0; i < values.count(); i += 4) {
                float one = values.signed(i + 2);
                float x = values.signed(i);
                float y = values.signed(i + 1);
                float z = one - Math.abs(x) - Math.abs(y);
                float fold = Math.min(z, 0);
                x -= Math.copySign(fold, x);
                y -= Math.copySign(fold, y);
                float scale = most / (float) Math.sqrt(x * x + y * y + z * z);
                values.set(i, round(x * scale));
                values.set(i + 1, round(y * scale));
                values.set(i + 2, round(z * scale));
            }
        }
    },

    /** Unit quaternions without their largest component, whose place is in the lowest bits of the last one. */
    QUATERNION {
        @Override
        boolean takes(int stride) {
            return stride == 8;
        }

        @Override
        void apply(Components values) {
            for (int i = 0; i < values.count(); i += 4) {
                int last = values.signed(i + 3);
                float scale = (float) (Short.MAX_VALUE * Math.sqrt(0.5)) / (last | 3);
                float x = values.signed(i) * scale;
                float y = values.signed(i + 1) * scale;
                float z = values.signed(i + 2) * scale;
                float w = (float) Math.sqrt(Math.max(0, SQUARE - x * x - y * y - z * z));
                values.set(i + (last + 1 & 3), round(x));
                values.set(i + (last + 2 & 3), round(y));
                values.set(i + (last + 3 & 3), round(z));
                values.set(i + (last & 3), round(w));
            }
        }
    },

    /** Floats as exponents of 8 and mantissas of 24 bits. */
    EXPONENTIAL {
        @Override
        boolean takes(int stride) {
            return true;
        }

        @Override
        void apply(Components values) {
            values.scaleFloats();
        }
    },

    /** Colours as luma and two differences; the highest bit of the last component tells the precision of all. */
    COLOR {
        @Override
        void apply(Components values) {
            int most = values.mostUnsigned();
            for (int i = 0; i < values.count(); i += 4) {
                int luma = values.unsigned(i);
                int orange = values.signed(i + 1);
                int green = values.signed(i + 2);
                int last = values.unsigned(i + 3);
                int highest = (Integer.highestOneBit(last) << 1) - 1;
                int alpha = last & highest >> 1;
                float scale = most / (float) highest;
                values.set(i, colour(luma + orange - green, scale, most));
                values.set(i + 1, colour(luma + green, scale, most));
                values.set(i + 2, colour(luma - orange - green, scale, most));
                values.set(i + 3, colour(alpha << 1 | alpha & 1, scale, most));
            }
        }
    };

    /** Of the length of a unit quaternion. */
    private static final float SQUARE = (float) Short.MAX_VALUE * Short.MAX_VALUE;

    static MeshoptFilter named(String name) throws PackedException {
        for (MeshoptFilter filter : values()) if (filter.name().equals(name)) return filter;
        throw new PackedException("the compression filter " + name + " is not known");
    }

    /** Whether elements of that many bytes can be filtered. */
    boolean takes(int stride) {
        return stride == 4 || stride == 8;
    }

    void apply(byte[] values, int stride) {
        apply(new Components(ByteBuffer.wrap(values).order(ByteOrder.LITTLE_ENDIAN), stride / 4));
    }

    abstract void apply(Components values);

    /** To the nearest integer, halves to the even one, as the fast decoders of others do. */
    private static int round(float value) {
        return (int) Math.rint(value);
    }

    private static int colour(int value, float scale, int most) {
        return Math.max(0, Math.min(most, round(value * scale)));
    }

    /** Components of one or two bytes each; {@link #EXPONENTIAL} alone reads four. */
    record Components(ByteBuffer values, int bytes) {
        int count() {
            return values.capacity() / bytes;
        }

        int mostSigned() {
            return bytes == 1 ? Byte.MAX_VALUE : Short.MAX_VALUE;
        }

        int mostUnsigned() {
            return bytes == 1 ? 0xFF : 0xFFFF;
        }

        int signed(int i) {
            return bytes == 1 ? values.get(i) : values.getShort(2 * i);
        }

        int unsigned(int i) {
            return signed(i) & mostUnsigned();
        }

        void set(int i, int value) {
            if (bytes == 1) values.put(i, (byte) value);
            else values.putShort(2 * i, (short) value);
        }

        void scaleFloats() {
            for (int at = 0; at < values.capacity(); at += 4) {
                int packed = values.getInt(at);
                values.putFloat(at, Math.scalb((float) (packed << 8 >> 8), packed >> 24));
            }
        }
    }
}
