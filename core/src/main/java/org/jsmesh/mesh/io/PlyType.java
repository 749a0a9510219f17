package org.jsmesh.mesh.io;

import java.nio.ByteBuffer;
import org.jsmesh.mesh.Channel;

/** The scalar types of PLY with both of their names. Those of 64 bits are not in the first description of PLY. */
enum PlyType {
    CHAR("char", "int8", 1),
    UCHAR("uchar", "uint8", 1),
    SHORT("short", "int16", 2),
    USHORT("ushort", "uint16", 2),
    INT("int", "int32", 4),
    UINT("uint", "uint32", 4),
    LONG("long", "int64", 8),
    ULONG("ulong", "uint64", 8),
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

    /** The name in a header, such as {@code uchar}. */
    String typeName() {
        return name;
    }

    int bytes() {
        return bytes;
    }

    boolean isInteger() {
        return this != FLOAT && this != DOUBLE;
    }

    /** How a channel holds such values: exactly, but for integers of 64 bits, which become float64. */
    Channel.Type channelType() {
        return switch (this) {
            case CHAR -> Channel.Type.INT8;
            case UCHAR -> Channel.Type.UINT8;
            case SHORT -> Channel.Type.INT16;
            case USHORT -> Channel.Type.UINT16;
            case INT -> Channel.Type.INT32;
            case UINT -> Channel.Type.UINT32;
            case FLOAT -> Channel.Type.FLOAT32;
            case LONG, ULONG, DOUBLE -> Channel.Type.FLOAT64;
        };
    }

    /** The type that holds the values of a channel. */
    static PlyType of(Channel.Type type) {
        for (PlyType candidate : values()) {
            if (candidate.channelType() == type && candidate != LONG && candidate != ULONG) return candidate;
        }
        throw new AssertionError(type);
    }

    /** The next value of binary data. Integers beyond 2^53 are rounded. */
    double get(ByteBuffer data) {
        return switch (this) {
            case CHAR -> data.get();
            case UCHAR -> data.get() & 0xFF;
            case SHORT -> data.getShort();
            case USHORT -> data.getShort() & 0xFFFF;
            case INT -> data.getInt();
            case UINT -> data.getInt() & 0xFFFFFFFFL;
            case LONG -> data.getLong();
            case ULONG -> unsigned(data.getLong());
            case FLOAT -> data.getFloat();
            case DOUBLE -> data.getDouble();
        };
    }

    private static double unsigned(long value) {
        return value >= 0 ? value : (value >>> 1) * 2.0;
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
            case LONG -> value >= -0x1p63 && value <= 0x1p63;
            case ULONG -> value >= 0 && value <= 0x1p64;
            default -> true;
        };
    }
}
