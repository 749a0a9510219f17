package org.jsmesh.files.gltf.read;

import com.fasterxml.jackson.databind.JsonNode;
import org.jsmesh.display.LinearLight;
import org.jsmesh.files.gltf.json.GltfExtras;
import org.jsmesh.files.gltf.json.JsonTree;
import org.jsmesh.mesh.Channel;

/**
 * What the extras of an accessor say of the channel that jSM wrote it from ({@link GltfExtras}). Another program may
 * have changed the accessor since; then its type is not the one that jSM writes, and the extras do not count.
 *
 * @param type of the channel
 * @param order place of the channel in the mesh
 * @param screen whether linear light of 16 bits stands for levels of a screen
 */
record KeptChannel(String name, Channel.Semantic semantic, Channel.Type type, int order, boolean screen) {
    private static final int LONGEST = 1000;
    private static final int SHORT_PER_BYTE = 257;
    private static final double FULL = 65535;

    /** Null where nothing is said, or what does not fit. */
    static KeptChannel of(JsonNode accessor, ComponentType stored, int components) {
        JsonNode jsm = accessor.path("extras").path(GltfExtras.JSM);
        Channel.Semantic semantic = value(Channel.Semantic.values(), jsm.path(GltfExtras.SEMANTIC));
        String name = jsm.path(GltfExtras.NAME).asText();
        if (name.isEmpty() || name.length() > LONGEST || semantic == null) return null;
        boolean typed = jsm.has(GltfExtras.TYPE);
        Channel.Type type = typed ? value(Channel.Type.values(), jsm.path(GltfExtras.TYPE)) : stored.type();
        boolean screen = jsm.path(GltfExtras.SCREEN).booleanValue();
        if (type == null || stored != written(type, screen) || semantic == Channel.Semantic.NORMAL && components != 3)
            return null;
        return new KeptChannel(name, semantic, type, JsonTree.index(jsm.path(GltfExtras.ORDER)), screen);
    }

    private static <T extends Enum<T>> T value(T[] values, JsonNode name) {
        for (T value : values) if (value.name().equals(name.asText())) return value;
        return null;
    }

    /** The component type in which numbers of a type are written. */
    private static ComponentType written(Channel.Type type, boolean screen) {
        return switch (type) {
            case UINT8 -> screen ? ComponentType.UNSIGNED_SHORT : ComponentType.UNSIGNED_BYTE;
            case INT8 -> ComponentType.BYTE;
            case UINT16 -> ComponentType.UNSIGNED_SHORT;
            case INT16 -> ComponentType.SHORT;
            default -> ComponentType.FLOAT;
        };
    }

    /** The number of the channel for one of the accessor, a whole one as it is. */
    double number(double given, int component) {
        if (!screen) return given;
        return component == 3 ? Math.rint(given / SHORT_PER_BYTE) : LinearLight.level(given / FULL);
    }
}
