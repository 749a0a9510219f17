package org.jsmesh.files.gltf.read;

import org.jsmesh.mesh.Channel;

/**
 * How a channel stores the values of an attribute.
 *
 * @param normalized are whole numbers parts of their largest?
 */
record StoredType(Channel.Type type, boolean normalized) {
    static final StoredType FLOATS = new StoredType(Channel.Type.FLOAT32, false);

    static StoredType of(GltfAccessor accessor) {
        return new StoredType(accessor.type().type(), accessor.isNormalized());
    }

    /** The smallest type that holds the numbers of both, those that are normalized as the parts they stand for. */
    StoredType with(StoredType other) {
        if (equals(other)) return this;
        if (!isWhole() || !other.isWhole()) {
            boolean wide = isWide() || other.isWide();
            return new StoredType(wide ? Channel.Type.FLOAT64 : Channel.Type.FLOAT32, false);
        }
        boolean signed = isSigned() || other.isSigned();
        int bits = Math.max(bits(signed), other.bits(signed));
        return new StoredType(
                switch (bits) {
                    case 8 -> signed ? Channel.Type.INT8 : Channel.Type.UINT8;
                    case 16 -> signed ? Channel.Type.INT16 : Channel.Type.UINT16;
                    case 32 -> signed ? Channel.Type.INT32 : Channel.Type.UINT32;
                    default -> Channel.Type.FLOAT64;
                },
                false);
    }

    private boolean isWhole() {
        return !type.isFloat() && !normalized;
    }

    private boolean isSigned() {
        return type == Channel.Type.INT8 || type == Channel.Type.INT16 || type == Channel.Type.INT32;
    }

    /** Does float32 lack some of its numbers? */
    private boolean isWide() {
        return type == Channel.Type.FLOAT64 || bits(false) == 32 && !type.isFloat();
    }

    /** Bits of its numbers as whole ones; a signed type needs more for those of an unsigned one. */
    private int bits(boolean signed) {
        int bits = switch (type) {
            case INT8, UINT8 -> 8;
            case INT16, UINT16 -> 16;
            case FLOAT64 -> 64;
            default -> 32;
        };
        return signed && !isSigned() ? 2 * bits : bits;
    }

    /** Stores a number. */
    void put(double number, int[] to, int at) {
        switch (type) {
            case FLOAT32 -> to[at] = Float.floatToRawIntBits((float) number);
            case FLOAT64 -> {
                long bits = Double.doubleToRawLongBits(number);
                to[at] = (int) bits;
                to[at + 1] = (int) (bits >>> 32);
            }
            default -> to[at] = (int) (long) number;
        }
    }
}
