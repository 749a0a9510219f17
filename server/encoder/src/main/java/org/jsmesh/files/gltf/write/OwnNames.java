package org.jsmesh.files.gltf.write;

import java.util.Set;
import org.jsmesh.files.gltf.json.AttributeNames;
import org.jsmesh.mesh.Channel;

/** Tells which channels have the names and types of attributes of glTF, as those of a file that was glTF have. */
final class OwnNames {
    static final String NORMALIZED = " normalized";

    private static final Set<Channel.Type> FLOAT = Set.of(Channel.Type.FLOAT32);
    private static final Set<Channel.Type> UNSIGNED = Set.of(Channel.Type.UINT8, Channel.Type.UINT16);
    private static final Set<Channel.Type> SIGNED = Set.of(Channel.Type.INT8, Channel.Type.INT16);

    private OwnNames() {}

    static boolean isOwn(Channel channel) {
        String name = attribute(channel);
        boolean marked = !name.equals(channel.name());
        int n = channel.components();
        Channel.Type type = channel.type();
        boolean floats = FLOAT.contains(type);
        boolean small = UNSIGNED.contains(type);
        boolean signed = SIGNED.contains(type);
        return switch (channel.semantic()) {
            case NORMAL -> name.equals("NORMAL") && n == 3 && (floats || signed);
            case TEXCOORD -> AttributeNames.isSet(name, "TEXCOORD") && n == 2 && (floats || small || signed);
            case COLOUR -> AttributeNames.isSet(name, "COLOR") && n >= 3 && (floats || small);
            case CUSTOM -> {
                if (name.startsWith("_")) yield AttributeNames.isKnown(name) && (small || signed || floats && !marked);
                if (n != 4) yield false;
                if (AttributeNames.isSet(name, "JOINTS")) yield small && !marked;
                if (AttributeNames.isSet(name, "WEIGHTS")) yield marked ? small : floats;
                yield name.equals("TANGENT") && floats;
            }
        };
    }

    /** The name without the mark of custom attributes whose whole numbers are parts of their largest. */
    static String attribute(Channel channel) {
        String name = channel.name();
        boolean marked = channel.semantic() == Channel.Semantic.CUSTOM && name.endsWith(NORMALIZED);
        return marked ? name.substring(0, name.length() - NORMALIZED.length()) : name;
    }

    /** Whether an attribute of glTF needs KHR_mesh_quantization for its type. */
    static boolean isQuantized(Channel channel) {
        return channel.semantic() != Channel.Semantic.CUSTOM && SIGNED.contains(channel.type());
    }
}
