package org.jsmesh.files.gltf.draco;

import org.jsmesh.files.gltf.packed.PackedBytes;
import org.jsmesh.files.gltf.packed.PackedException;

/**
 * What an attribute is.
 *
 * @param isPosition whether others are predicted from it
 * @param type the type of its numbers in the numbering of Draco
 */
record AttributeKind(boolean isPosition, int type, int components, boolean normalized, int uniqueId) {
    static final int FLOAT = 9;
    private static final int POSITION = 0;
    /** What glTF calls the types of Draco; 0 is none. It has no signed numbers of 32 bits. */
    private static final int[] GLTF_TYPES = {0, 5120, 5121, 5122, 5123, 5125, 5125, 0, 0, 5126, 0, 5121};

    static AttributeKind read(PackedBytes in) throws PackedException {
        boolean isPosition = in.next() == POSITION;
        int type = in.next();
        int components = in.next();
        boolean normalized = in.next() != 0;
        if (type >= GLTF_TYPES.length || GLTF_TYPES[type] == 0) {
            throw new PackedException("numbers of the Draco type " + type + " cannot be in glTF");
        }
        if (components == 0) throw new PackedException("an attribute of the Draco mesh has no components");
        return new AttributeKind(isPosition, type, components, normalized, in.varint());
    }

    /** Bytes of a number. */
    int size() {
        return switch (GLTF_TYPES[type]) {
            case 5120, 5121 -> 1;
            case 5122, 5123 -> 2;
            default -> 4;
        };
    }

    DracoAttribute attribute(byte[] values) {
        return new DracoAttribute(components, GLTF_TYPES[type], normalized, values);
    }
}
