package org.jsmesh.files.gltf.read;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.AbstractList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.jsmesh.files.gltf.json.JsonTree;
import org.jsmesh.mesh.Note;

/** The places that a node gives its mesh by EXT_mesh_gpu_instancing. */
final class MeshInstancing {
    private static final String EXTENSION = "EXT_mesh_gpu_instancing";
    private static final Set<String> PLACES = Set.of("TRANSLATION", "ROTATION", "SCALE");

    private final GltfDocument document;
    private final Set<String> dropped = new TreeSet<>();

    MeshInstancing(GltfDocument document) {
        this.document = document;
    }

    static JsonNode attributes(JsonNode node) {
        return node.path("extensions").path(EXTENSION).path("attributes");
    }

    /** One for each instance within its node; the unit where the node has none. */
    List<Transform> transforms(JsonNode node) throws IOException {
        JsonNode attributes = attributes(node);
        if (attributes.isEmpty()) return List.of(Transform.IDENTITY);
        int count = Integer.MAX_VALUE;
        for (Map.Entry<String, JsonNode> attribute : attributes.properties()) {
            count = Math.min(count, document.accessor(attribute.getValue()).count());
            if (!PLACES.contains(attribute.getKey())) dropped.add(attribute.getKey());
        }
        GltfAccessor moves = accessor(attributes, "TRANSLATION", 3);
        GltfAccessor turns = accessor(attributes, "ROTATION", 4);
        GltfAccessor scales = accessor(attributes, "SCALE", 3);
        int size = count;
        return new AbstractList<>() {
            @Override
            public Transform get(int i) {
                return Transform.of(
                        values(moves, i, Transform.NO_MOVE),
                        values(turns, i, Transform.NO_TURN),
                        values(scales, i, Transform.NO_SCALE));
            }

            @Override
            public int size() {
                return size;
            }
        };
    }

    /** Whether bytes of the file tell the instances apart. */
    boolean hasBytes(JsonNode node) throws IOException {
        JsonNode attributes = attributes(node);
        boolean has = attributes.isEmpty();
        for (JsonNode number : attributes) has |= document.accessor(number).hasBytes();
        return has;
    }

    private GltfAccessor accessor(JsonNode attributes, String name, int components) throws IOException {
        JsonNode number = attributes.path(name);
        if (!JsonTree.isGiven(number)) return null;
        GltfAccessor accessor = document.accessor(number);
        if (accessor.components() != components)
            throw document.error(name + " of instances has " + accessor.components() + " components");
        return accessor;
    }

    private static double[] values(GltfAccessor accessor, int element, double[] otherwise) {
        if (accessor == null) return otherwise;
        double[] values = new double[otherwise.length];
        for (int c = 0; c < values.length; c++) values[c] = accessor.number(element, c);
        return values;
    }

    void report(List<Note> notes) {
        if (dropped.isEmpty()) return;
        Note note = NoteText.note(Note.Kind.DROPPED, "Attributes of instances dropped", dropped);
        notes.add(
                dropped.stream().anyMatch(name -> name.startsWith("_COLOR") || name.startsWith("COLOR"))
                        ? note.asWarning()
                        : note);
    }
}
