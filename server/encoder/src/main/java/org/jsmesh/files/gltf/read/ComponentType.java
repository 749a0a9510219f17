package org.jsmesh.files.gltf.read;

import com.fasterxml.jackson.databind.JsonNode;
import java.nio.ByteBuffer;
import org.jsmesh.files.gltf.json.JsonTree;
import org.jsmesh.mesh.Channel;

/** How one component of an accessor is stored (glTF 2.0 specification, section 3.6.2.2). */
public enum ComponentType {
    BYTE(5120, 1, Channel.Type.INT8, 127),
    UNSIGNED_BYTE(5121, 1, Channel.Type.UINT8, 255),
    SHORT(5122, 2, Channel.Type.INT16, 32767),
    UNSIGNED_SHORT(5123, 2, Channel.Type.UINT16, 65535),
    UNSIGNED_INT(5125, 4, Channel.Type.UINT32, 4294967295.0),
    FLOAT(5126, 4, Channel.Type.FLOAT32, 1);

    private final int code;
    private final int bytes;
    private final Channel.Type type;
    private final double full;

    ComponentType(int code, int bytes, Channel.Type type, double full) {
        this.code = code;
        this.bytes = bytes;
        this.type = type;
        this.full = full;
    }

    /** The type of a number that glTF gives it, or null. */
    static ComponentType of(JsonNode code) {
        return of(JsonTree.index(code));
    }

    /** The type of a number that glTF gives it, or null. */
    static ComponentType of(int code) {
        for (ComponentType type : values()) if (type.code == code) return type;
        return null;
    }

    /** The number that glTF gives it. */
    public int code() {
        return code;
    }

    public int bytes() {
        return bytes;
    }

    /** The type that holds the same bits in a channel. */
    Channel.Type type() {
        return type;
    }

    /** The bits at a place of little-endian bytes, as a channel holds them. */
    int raw(ByteBuffer from, int at) {
        return switch (this) {
            case BYTE -> from.get(at);
            case UNSIGNED_BYTE -> from.get(at) & 0xFF;
            case SHORT -> from.getShort(at);
            case UNSIGNED_SHORT -> from.getShort(at) & 0xFFFF;
            default -> from.getInt(at);
        };
    }

    /** The number that bits stand for: a part of the largest when normalized. */
    double number(int raw, boolean normalized) {
        double value = switch (this) {
            case FLOAT -> Float.intBitsToFloat(raw);
            case UNSIGNED_INT -> raw & 0xFFFFFFFFL;
            default -> raw;
        };
        return normalized && this != FLOAT ? Math.max(value / full, -1) : value;
    }
}
