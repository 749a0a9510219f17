package org.jsmesh.files.gltf.read;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.io.CornerAttribute;

/** The attributes of all baked vertices by their names in glTF. */
final class BakedAttributes {
    /** An archive holds no more. */
    private static final int MOST = 64;

    private record Admitted(int mesh, boolean keepsDirections) {}

    private final GltfDocument document;
    private final Map<String, BakedAttribute> attributes = new TreeMap<>();
    private final Map<GltfPrimitive, Columns> columns = new HashMap<>();
    private final Set<Admitted> admitted = new HashSet<>();
    private final Set<String> dropped = new TreeSet<>();
    private final Set<String> odd = new TreeSet<>();

    BakedAttributes(GltfDocument document) {
        this.document = document;
    }

    /** Makes room for the attributes of a mesh under a transform. */
    void admit(int mesh, MeshParts parts, Transform transform) throws IOException {
        if (!admitted.add(new Admitted(mesh, transform.keepsDirections()))) return;
        for (GltfPrimitive primitive : parts.primitives()) {
            for (String name : primitive.unusable()) (BakedAttribute.isKept(name) ? odd : dropped).add(name);
            for (Map.Entry<String, GltfAccessor> entry : primitive.attributes().entrySet()) {
                if (entry.getKey().equals("POSITION")) continue;
                String name = name(entry);
                BakedAttribute attribute = attributes.get(name);
                if (attribute == null)
                    attribute =
                            new BakedAttribute(document, name, entry.getValue().kept());
                boolean isNew = !attributes.containsKey(name);
                if (!isUsable(attribute, primitive, entry.getValue()) || isNew && attributes.size() == MOST) {
                    odd.add(name);
                    continue;
                }
                attribute.admit(entry.getValue(), transform);
                attributes.put(name, attribute);
            }
        }
    }

    /** That of the channel that jSM wrote, or that of the attribute. */
    private static String name(Map.Entry<String, GltfAccessor> entry) {
        KeptChannel kept = entry.getValue().kept();
        return kept == null ? entry.getKey() : kept.name();
    }

    private static boolean isUsable(BakedAttribute attribute, GltfPrimitive primitive, GltfAccessor accessor)
            throws IOException {
        return attribute.fits(accessor)
                && accessor.count() >= primitive.positions().count();
    }

    /** The attributes that a primitive has. */
    Columns columns(GltfPrimitive primitive) throws IOException {
        Columns known = columns.get(primitive);
        if (known == null) {
            known = find(primitive);
            columns.put(primitive, known);
        }
        return known;
    }

    private Columns find(GltfPrimitive primitive) throws IOException {
        Columns found = new Columns(new ArrayList<>(), new ArrayList<>());
        for (Map.Entry<String, GltfAccessor> entry : primitive.attributes().entrySet()) {
            BakedAttribute attribute = attributes.get(name(entry));
            if (attribute == null || !isUsable(attribute, primitive, entry.getValue())) continue;
            found.attributes.add(attribute);
            found.accessors.add(entry.getValue());
        }
        return found;
    }

    /** Attributes with the accessors of a primitive. */
    record Columns(List<BakedAttribute> attributes, List<GltfAccessor> accessors) {
        void add(int vertex, int element, Transform transform) throws IOException {
            for (int i = 0; i < attributes.size(); i++)
                attributes.get(i).add(vertex, accessors.get(i), element, transform);
        }
    }

    void report(List<Note> notes) {
        for (BakedAttribute attribute : attributes.values()) attribute.report(notes);
        if (!dropped.isEmpty()) notes.add(NoteText.note(Note.Kind.DROPPED, "Vertex attributes dropped", dropped));
        if (odd.isEmpty()) return;
        String text = "Vertex attributes of a kind or a length that does not fit dropped";
        Note note = NoteText.note(Note.Kind.DROPPED, text, odd);
        notes.add(odd.stream().allMatch(name -> name.startsWith("_")) ? note : note.asWarning());
    }

    List<CornerAttribute> of(int[] cornerVertices) {
        Set<String> taken = new HashSet<>();
        return attributes.values().stream()
                .sorted(Comparator.comparingInt(BakedAttribute::order).thenComparing(BakedAttribute::semantic))
                .map(attribute -> attribute.attribute(cornerVertices, taken))
                .toList();
    }
}
