package org.jsmesh.files.gltf;

import de.javagl.jgltf.impl.v2.Mesh;
import de.javagl.jgltf.impl.v2.MeshPrimitive;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.io.CornerAttribute;
import org.jsmesh.mesh.io.MeshAssembler;

/** Collects the primitives of a scene as one list of triangles in world space. */
final class MeshBaker {
    /** Most triangles of a scene. One mesh may appear in many nodes, and nobody means a model with more. */
    private static final int MOST_TRIANGLES = 50_000_000;

    /** The place of a mesh. */
    record Instance(int mesh, Transform transform) {}

    private final GltfDocument document;
    private final List<Note> notes;
    private final Map<String, BakedAttribute> attributes = new TreeMap<>();
    private final Set<String> dropped = new TreeSet<>();
    private float[] positions = new float[1024];
    private int vertices;
    private int[] corners = new int[1024];
    private int cornerCount;
    private int[] faceMaterials = new int[512];
    private int otherPrimitives;
    private int stitches;
    private int oddIndices;
    private int morphs;

    MeshBaker(GltfDocument document, List<Note> notes) {
        this.document = document;
        this.notes = notes;
    }

    void bake(List<Instance> instances) throws IOException {
        for (Instance instance : instances) admit(mesh(instance));
        for (Instance instance : instances) {
            for (MeshPrimitive primitive : primitives(mesh(instance))) bake(primitive, instance.transform);
        }
        report();
    }

    private void report() {
        if (otherPrimitives > 0) {
            String text = GltfNames.count(otherPrimitives, "primitive") + " left out: points, lines or no positions.";
            notes.add(Note.dropped(text, otherPrimitives, ""));
        }
        if (stitches > 0) {
            String text = GltfNames.count(stitches, "degenerate triangle") + " that stitch strips dropped.";
            notes.add(Note.repaired(text, stitches, ""));
        }
        if (oddIndices > 0) {
            String text = GltfNames.count(oddIndices, "primitive")
                    + " whose number of corners is no multiple of three: the rest left out.";
            notes.add(Note.dropped(text, oddIndices, ""));
        }
        if (morphs > 0) notes.add(Note.dropped("Morph targets dropped.", morphs, ""));
        if (!dropped.isEmpty()) notes.add(GltfNames.note(Note.Kind.DROPPED, "Vertex attributes dropped", dropped));
    }

    private Mesh mesh(Instance instance) throws IOException {
        return document.get(document.gltf().getMeshes(), instance.mesh, "mesh");
    }

    private static List<MeshPrimitive> primitives(Mesh mesh) {
        return mesh.getPrimitives() == null ? List.of() : mesh.getPrimitives();
    }

    private static Map<String, Integer> attributes(MeshPrimitive primitive) {
        return primitive.getAttributes() == null ? Map.of() : primitive.getAttributes();
    }

    private static boolean isBaked(MeshPrimitive primitive) {
        return TriangleSource.hasTriangles(primitive) && attributes(primitive).containsKey("POSITION");
    }

    private void admit(Mesh mesh) throws IOException {
        for (MeshPrimitive primitive : primitives(mesh)) {
            if (!isBaked(primitive)) continue;
            for (Map.Entry<String, Integer> entry : attributes(primitive).entrySet()) {
                String name = entry.getKey();
                if (BakedAttribute.isKept(name)) {
                    attributes
                            .computeIfAbsent(name, n -> new BakedAttribute(document, n))
                            .admit(document.accessor(entry.getValue()));
                } else if (!name.equals("POSITION")) {
                    dropped.add(name);
                }
            }
        }
    }

    private void bake(MeshPrimitive primitive, Transform transform) throws IOException {
        if (!isBaked(primitive)) {
            otherPrimitives++;
            return;
        }
        if (primitive.getTargets() != null) morphs += primitive.getTargets().size();
        GltfAccessor position = document.accessor(attributes(primitive).get("POSITION"));
        if (position.components() != 3) throw document.error("POSITION has " + position.components() + " components");
        for (Map.Entry<String, Integer> entry : attributes(primitive).entrySet()) {
            if (attributes.containsKey(entry.getKey())
                    && document.accessor(entry.getValue()).count() < position.count()) {
                throw document.error(entry.getKey() + " has fewer elements than POSITION");
            }
        }
        TriangleSource source = new TriangleSource(document, primitive, position.count());
        if (cornerCount / 3 + (long) source.count() > MOST_TRIANGLES) {
            throw document.error(
                    "more than " + MOST_TRIANGLES + " triangles", "Split the scene or remove repeated meshes");
        }
        if (source.hasRest()) oddIndices++;
        int[] baked = new int[position.count()];
        Arrays.fill(baked, -1);
        int material = primitive.getMaterial() == null ? -1 : primitive.getMaterial();
        boolean mirrored = transform.mirrors();
        for (int t = 0; t < source.count(); t++) {
            int[] triangle = source.triangle(t);
            if (triangle == null) {
                stitches++;
                continue;
            }
            for (int i = 0; i < 3; i++) {
                int element = triangle[mirrored ? 2 - i : i];
                if (baked[element] < 0) baked[element] = bakeVertex(primitive, position, element, transform);
                corner(baked[element]);
            }
            material(material);
        }
    }

    private int bakeVertex(MeshPrimitive primitive, GltfAccessor position, int element, Transform transform)
            throws IOException {
        float[] point = {position.number(element, 0), position.number(element, 1), position.number(element, 2)};
        transform.point(point);
        if (3 * vertices + 3 > positions.length) positions = Arrays.copyOf(positions, 2 * positions.length);
        for (int i = 0; i < 3; i++) {
            if (Float.isNaN(point[i]) || Float.isInfinite(point[i]))
                throw document.error("a vertex is beyond the range of float32 in world space", "Scale the scene down");
            positions[3 * vertices + i] = point[i];
        }
        for (Map.Entry<String, Integer> entry : attributes(primitive).entrySet()) {
            BakedAttribute attribute = attributes.get(entry.getKey());
            if (attribute != null) attribute.add(vertices, document.accessor(entry.getValue()), element, transform);
        }
        return vertices++;
    }

    private void corner(int vertex) {
        if (cornerCount == corners.length) corners = Arrays.copyOf(corners, 2 * corners.length);
        corners[cornerCount++] = vertex;
    }

    private void material(int material) {
        int face = cornerCount / 3 - 1;
        if (face == faceMaterials.length) faceMaterials = Arrays.copyOf(faceMaterials, 2 * faceMaterials.length);
        faceMaterials[face] = material;
    }

    /** glTF's material of each face, −1 for none. */
    int[] faceMaterials() {
        return Arrays.copyOf(faceMaterials, cornerCount / 3);
    }

    /** Everything but the materials, welded by position. */
    MeshAssembler assembler() {
        int[] cornerVertices = Arrays.copyOf(corners, cornerCount);
        int[] faceCorners = new int[cornerCount];
        Arrays.setAll(faceCorners, i -> i);
        MeshAssembler assembler =
                new MeshAssembler(Arrays.copyOf(positions, 3 * vertices), cornerVertices, faceCorners).weld(true);
        List<CornerAttribute> baked = new ArrayList<>();
        for (BakedAttribute attribute : attributes.values()) baked.add(attribute.attribute(cornerVertices));
        baked.sort(Comparator.comparing(CornerAttribute::semantic));
        baked.forEach(assembler::attribute);
        return assembler;
    }
}
