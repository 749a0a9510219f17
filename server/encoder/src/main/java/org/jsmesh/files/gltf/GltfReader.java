package org.jsmesh.files.gltf;

import com.fasterxml.jackson.databind.JsonNode;
import de.javagl.jgltf.impl.v2.GlTF;
import de.javagl.jgltf.impl.v2.Node;
import de.javagl.jgltf.impl.v2.Scene;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.io.ModelFile;
import org.jsmesh.mesh.io.ModelFormat;
import org.jsmesh.mesh.io.ModelFormatException;
import org.jsmesh.mesh.io.ResourceResolver;

/**
 * Reads glTF 2.0, GLB or JSON, as one mesh: every node of the scene is baked to world space in double arithmetic,
 * rounded once to float32, and seams are welded. Nodes without a transform keep every bit. Skins, morph targets and
 * animations are dropped and reported.
 */
public final class GltfReader {
    private static final Set<String> COMPRESSIONS =
            Set.of("KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression");
    private static final Set<String> UNDERSTOOD = Set.of("KHR_mesh_quantization");

    private record Visit(int node, Transform parent) {}

    private final GltfDocument document;
    private final List<Note> notes = new ArrayList<>();

    private GltfReader(GltfDocument document) {
        this.document = document;
    }

    /**
     * @param fileName for messages
     * @param content the whole file
     * @param resources finds the buffers and images that are not within the file
     * @throws ModelFormatException when the content is not glTF 2.0 or damaged
     * @throws IOException when a resource cannot be read
     */
    public static ModelFile read(String fileName, byte[] content, ResourceResolver resources) throws IOException {
        return new GltfReader(new GltfDocument(fileName, content, resources)).read();
    }

    private ModelFile read() throws IOException {
        GlTF gltf = document.gltf();
        noteExtensions(gltf);
        List<MeshBaker.Instance> instances = instances(gltf);
        MeshBaker baker = new MeshBaker(document, notes);
        baker.bake(instances);
        if (gltf.getSkins() != null && !gltf.getSkins().isEmpty()) {
            String text = "Skins dropped: meshes are in the pose they were modelled in.";
            notes.add(Note.dropped(text, gltf.getSkins().size(), "skin 0"));
        }
        if (gltf.getAnimations() != null && !gltf.getAnimations().isEmpty())
            notes.add(Note.dropped("Animations dropped.", gltf.getAnimations().size(), "animation 0"));
        Mesh mesh = new GltfMaterials(document, notes)
                .addTo(baker.assembler(), baker.faceMaterials())
                .build();
        return new ModelFile(mesh, ModelFormat.GLB, notes);
    }

    private void noteExtensions(GlTF gltf) throws ModelFormatException {
        Set<String> unknown = new TreeSet<>();
        if (gltf.getExtensionsRequired() != null) {
            for (String name : gltf.getExtensionsRequired()) {
                if (name != null && COMPRESSIONS.contains(name)) {
                    throw document.error(
                            "the meshes are compressed with " + name, "Export the model without mesh compression");
                }
            }
            unknown.addAll(present(gltf.getExtensionsRequired()));
        }
        if (gltf.getExtensionsUsed() != null) unknown.addAll(present(gltf.getExtensionsUsed()));
        unknown.removeAll(UNDERSTOOD);
        if (document.root().path("asset").path("generator").asText().equals(GltfWriter.GENERATOR))
            unknown.remove(GltfWriter.TEXTURE_TRANSFORM);
        if (!unknown.isEmpty()) notes.add(GltfNames.note(Note.Kind.UNREAD, "Extensions not read", unknown));
    }

    private static List<String> present(List<String> names) {
        return names.stream().filter(n -> n != null).toList();
    }

    private List<MeshBaker.Instance> instances(GlTF gltf) throws IOException {
        List<MeshBaker.Instance> instances = new ArrayList<>();
        Deque<Visit> open = new ArrayDeque<>();
        pushReversed(open, roots(gltf), Transform.IDENTITY);
        BitSet visited = new BitSet();
        while (!open.isEmpty()) {
            Visit visit = open.pop();
            Node node = document.get(gltf.getNodes(), visit.node, "node");
            if (visited.get(visit.node)) throw document.error("node " + visit.node + " is in the scene twice");
            visited.set(visit.node);
            JsonNode json = document.root().path("nodes").path(visit.node);
            Transform world = visit.parent.times(Transform.of(json));
            if (node.getMesh() != null) instances.add(new MeshBaker.Instance(node.getMesh(), world));
            if (node.getChildren() != null) pushReversed(open, node.getChildren(), world);
        }
        return instances;
    }

    private void pushReversed(Deque<Visit> open, List<Integer> nodes, Transform parent) throws ModelFormatException {
        for (int i = nodes.size() - 1; i >= 0; i--) {
            if (nodes.get(i) == null) throw document.error("a node is null");
            open.push(new Visit(nodes.get(i), parent));
        }
    }

    /** Nodes of the scene that the file shows; without scenes, all nodes that are no children. */
    private List<Integer> roots(GlTF gltf) throws ModelFormatException {
        if (gltf.getScenes() != null && !gltf.getScenes().isEmpty()) {
            Scene scene = document.get(
                    gltf.getScenes(), gltf.getScene() == null ? Integer.valueOf(0) : gltf.getScene(), "scene");
            int scenes = gltf.getScenes().size();
            if (scenes > 1) notes.add(Note.unread("Of " + scenes + " scenes one read.", scenes - 1, ""));
            return scene.getNodes() == null ? List.of() : scene.getNodes();
        }
        int count = gltf.getNodes() == null ? 0 : gltf.getNodes().size();
        BitSet children = new BitSet();
        for (int n = 0; n < count; n++) {
            List<Integer> list = document.get(gltf.getNodes(), n, "node").getChildren();
            if (list == null) continue;
            for (Integer child : list) {
                if (child != null && child >= 0 && child < count) children.set(child);
            }
        }
        List<Integer> roots = new ArrayList<>();
        for (int n = 0; n < count; n++) {
            if (!children.get(n)) roots.add(n);
        }
        return roots;
    }
}
