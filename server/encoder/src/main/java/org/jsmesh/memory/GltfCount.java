package org.jsmesh.memory;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;

/** Counts by the accessors of a glTF file, compressed ones included, and by how often nodes show each mesh. */
final class GltfCount {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final int MOST_DESCRIPTION = 256 << 20;
    private static final int CHUNK = 20;

    /** Bytes of a file for each triangle where the description cannot be read: indices, half a vertex with a normal. */
    private static final int LIKELY_BYTES = 24;

    private final JsonNode root;
    private double faces;
    private double vertices;
    private int channels;

    private GltfCount(JsonNode root) {
        this.root = root;
    }

    static ModelCount of(Sampled file) throws IOException {
        boolean binary = file.startsWith("glTF");
        long bytes = binary ? file.littleEndian(12) : file.length();
        byte[] text = new byte[0];
        if (bytes <= MOST_DESCRIPTION) text = file.read(binary ? CHUNK : 0, (int) bytes);
        if (text.length == bytes) {
            try {
                GltfCount count = new GltfCount(JSON.readTree(text));
                count.count();
                return ModelCount.exact(count.faces, count.vertices, count.channels, file)
                        .withMaterials(count.root.path("materials").size() > 1);
            } catch (JsonProcessingException e) {
                // Reading it will tell.
            }
        }
        double faces = (double) file.length() / LIKELY_BYTES;
        return new ModelCount(faces, 0, faces, 5, file.length(), 0, false, false);
    }

    private void count() {
        int[] shown = new int[root.path("meshes").size()];
        for (JsonNode node : root.path("nodes")) {
            int mesh = node.path("mesh").asInt(-1);
            if (mesh >= 0 && mesh < shown.length) shown[mesh] += instances(node);
        }
        int at = 0;
        for (JsonNode mesh : root.path("meshes")) {
            int times = Math.max(root.path("nodes").isEmpty() ? 1 : 0, shown[at++]);
            for (JsonNode primitive : mesh.path("primitives")) count(primitive, times);
        }
    }

    private int instances(JsonNode node) {
        JsonNode many = node.path("extensions").path("EXT_mesh_gpu_instancing").path("attributes");
        for (JsonNode attribute : many) return (int) Math.max(1, number(attribute));
        return 1;
    }

    private void count(JsonNode primitive, int times) {
        JsonNode attributes = primitive.path("attributes");
        double points = number(attributes.path("POSITION"));
        double corners = primitive.has("indices") ? number(primitive.path("indices")) : points;
        int mode = primitive.path("mode").asInt(4);
        if (mode < 4) return;
        faces += times * (mode == 4 ? Math.floor(corners / 3) : Math.max(0, corners - 2));
        vertices += times * points;
        int values = 0;
        for (String name : (Iterable<String>) attributes::fieldNames) {
            if (!name.equals("POSITION")) values += components(attributes.path(name));
        }
        channels = Math.max(channels, values);
    }

    private double number(JsonNode accessor) {
        return accessor.isInt()
                ? Math.max(
                        0,
                        root.path("accessors")
                                .path(accessor.asInt())
                                .path("count")
                                .asDouble())
                : 0;
    }

    private int components(JsonNode accessor) {
        return switch (root.path("accessors")
                .path(accessor.asInt(-1))
                .path("type")
                .asText()) {
            case "VEC2" -> 2;
            case "VEC3" -> 3;
            case "VEC4" -> 4;
            default -> 1;
        };
    }
}
