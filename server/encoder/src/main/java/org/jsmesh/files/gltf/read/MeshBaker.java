package org.jsmesh.files.gltf.read;

import java.io.IOException;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.io.MeshAssembler;

/** Collects the primitives of a scene as one list of triangles in world space. */
final class MeshBaker {
    private final GltfDocument document;
    private final List<Note> notes;
    private final BakerNotes counts = new BakerNotes();
    private final Map<Integer, MeshParts> meshes = new HashMap<>();
    private final BakedAttributes attributes;
    private final Map<String, Integer> names = new LinkedHashMap<>();
    private double[] positions = new double[1024];
    private int vertices;
    private int[] corners = new int[1024];
    private int cornerCount;
    private int[] faceMaterials = new int[512];
    private int[] faceNames = new int[512];
    private int[] baked = new int[0]; // vertex of an element of the primitive at hand, or −1

    MeshBaker(GltfDocument document, List<Note> notes) {
        this.document = document;
        this.notes = notes;
        attributes = new BakedAttributes(document);
    }

    void bake(List<MeshInstance> instances) throws IOException {
        limit(instances);
        for (MeshInstance instance : instances) {
            attributes.admit(instance.mesh(), parts(instance), instance.transform());
            counts.add(parts(instance));
        }
        for (MeshInstance instance : instances) {
            if (parts(instance).primitives().isEmpty()) continue;
            int name = names.computeIfAbsent(instance.name(), n -> names.size());
            for (GltfPrimitive primitive : parts(instance).primitives()) {
                bake(primitive, instance.transform(), name);
                counts.addMorphs(primitive.morphTargets(), instance.isMorphed());
            }
        }
        if (cornerCount == 0) counts.requireTriangles(document);
        counts.report(notes);
        attributes.report(notes);
    }

    /** Refuses what is too much before it takes memory. */
    private void limit(List<MeshInstance> instances) throws IOException {
        long triangles = 0;
        long zeros = 0;
        long faces = 0;
        for (MeshInstance instance : instances) {
            MeshParts parts = parts(instance);
            triangles += parts.triangles();
            zeros += instance.hasBytes() ? parts.zeros() : parts.triangles();
            faces += parts.faces();
        }
        String remedy = "Split the scene or remove repeated meshes";
        if (triangles > document.mostElements())
            throw document.error("more than " + document.mostElements() + " triangles", remedy);
        if (zeros > document.mostZeros())
            throw document.error(
                    "more than " + document.mostZeros() + " triangles without bytes of the file behind them", remedy);
        if (faces > document.mostFaces())
            throw document.error(
                    "the model has " + faces + " faces, more than the " + document.mostFaces() + " allowed",
                    "Give a smaller model");
    }

    private MeshParts parts(MeshInstance instance) throws IOException {
        MeshParts known = meshes.get(instance.mesh());
        if (known == null) {
            known = MeshParts.of(document, instance.mesh());
            meshes.put(instance.mesh(), known);
        }
        return known;
    }

    private void bake(GltfPrimitive primitive, Transform transform, int name) throws IOException {
        GltfAccessor position = primitive.positions();
        TriangleSource source = primitive.triangles();
        BakedAttributes.Columns columns = attributes.columns(primitive);
        if (baked.length < position.count()) {
            baked = new int[position.count()];
            Arrays.fill(baked, -1);
        }
        boolean mirrored = transform.mirrors();
        int first = cornerCount;
        for (int t = 0; t < source.count(); t++) {
            int[] triangle = source.triangle(t);
            if (triangle == null) {
                counts.addStitch();
                continue;
            }
            for (int i = 0; i < 3; i++) {
                int element = triangle[mirrored ? 2 - i : i];
                if (baked[element] < 0) {
                    baked[element] = bakeVertex(position, element, transform);
                    columns.add(baked[element], element, transform);
                }
                corner(baked[element]);
            }
            face(primitive.material(), name);
        }
        if (cornerCount > first) forget(source);
    }

    /** The next primitive numbers its elements anew. */
    private void forget(TriangleSource source) throws IOException {
        for (int t = 0; t < source.count(); t++) {
            int[] triangle = source.triangle(t);
            if (triangle == null) continue;
            for (int element : triangle) baked[element] = -1;
        }
    }

    private int bakeVertex(GltfAccessor position, int element, Transform transform) throws IOException {
        double[] point = {position.finite(element, 0), position.finite(element, 1), position.finite(element, 2)};
        transform.point(point);
        if (3 * vertices + 3 > positions.length) positions = Arrays.copyOf(positions, 2 * positions.length);
        for (int i = 0; i < 3; i++) {
            if (!Float.isFinite((float) point[i]))
                throw document.error("a vertex is beyond the range of float32 in world space", "Scale the scene down");
            positions[3 * vertices + i] = point[i];
        }
        return vertices++;
    }

    private void corner(int vertex) {
        if (cornerCount == corners.length) corners = Arrays.copyOf(corners, 2 * corners.length);
        corners[cornerCount++] = vertex;
    }

    private void face(int material, int name) {
        int face = cornerCount / 3 - 1;
        if (face == faceMaterials.length) {
            faceMaterials = Arrays.copyOf(faceMaterials, 2 * face);
            faceNames = Arrays.copyOf(faceNames, 2 * face);
        }
        faceMaterials[face] = material;
        faceNames[face] = name;
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
        double[] world = WorldPositions.rounded(Arrays.copyOf(positions, 3 * vertices));
        MeshAssembler assembler = new MeshAssembler(world, cornerVertices, faceCorners).weld(true);
        attributes.of(cornerVertices).forEach(assembler::attribute);
        nameFaces(assembler);
        return assembler;
    }

    private void nameFaces(MeshAssembler assembler) {
        List<String> labels = List.copyOf(names.keySet());
        int[] numbers = Arrays.copyOf(faceNames, cornerCount / 3);
        if (Arrays.stream(numbers).allMatch(number -> labels.get(number).isEmpty())) return;
        assembler.faceChannel(new FaceChannel(FaceChannel.OBJECT, 1, Channel.Type.INT32, numbers, labels));
    }
}
