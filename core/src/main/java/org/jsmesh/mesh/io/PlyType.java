package org.jsmesh.mesh.io;

/** The scalar types of PLY with both of their names. */
enum PlyType {
    CHAR("char", "int8", 1),
    UCHAR("uchar", "uint8", 1),
    SHORT("short", "int16", 2),
    USHORT("ushort", "uint16", 2),
    INT("int", "int32", 4),
    UINT("uint", "uint32", 4),
    FLOAT("float", "float32", 4),
    DOUBLE("double", "float64", 8);

    private final String name;
    private final String sizedName;
    private final int bytes;

    PlyType(String name, String sizedName, int bytes) {
        this.name = name;
        this.sizedName = sizedName;
        this.bytes = bytes;
    }

    /** Or null. */
    static PlyType named(String word) {
        for (PlyType type : values()) {
            if (type.name.equals(word) || type.sizedName.equals(word)) return type;
        }
        return null;
    }

    int bytes() {
        return bytes;
    }

    boolean isInteger() {
        return this != FLOAT && this != DOUBLE;
    }

    /** Whether an integer type can hold a value. */
    boolean holds(double value) {
        return switch (this) {
            case CHAR -> value >= -128 && value <= 127;
            case UCHAR -> value >= 0 && value <= 255;
            case SHORT -> value >= -32768 && value <= 32767;
            case USHORT -> value >= 0 && value <= 65535;
            case INT -> value >= Integer.MIN_VALUE && value <= Integer.MAX_VALUE;
            case UINT -> value >= 0 && value <= 4294967295.0;
            default -> true;
        };
    }
}
