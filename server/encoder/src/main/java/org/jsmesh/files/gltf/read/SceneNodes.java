package org.jsmesh.files.gltf.read;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import org.jsmesh.files.gltf.json.JsonTree;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.io.ModelFormatException;

/**
 * Walks the nodes of the scene that the file shows. A mesh stands wherever a node, or an instance of a node, puts it.
 * The transform of a node with a skin is ignored (glTF 2.0 specification, section 3.7.3.3).
 */
final class SceneNodes {
    /** Most places of meshes, and most nodes and parts of nodes on all ways through the scene. */
    private static final int MOST = 1_000_000;

    private static final int MOST_WEIGHTS = 1000;

    /** @param node negative when it is left */
    private record Visit(int node, Transform parent) {}

    private final GltfDocument document;
    private final List<Note> notes;
    private final List<MeshInstance> instances = new ArrayList<>();
    private final BitSet above = new BitSet();
    private final BitSet seen = new BitSet();
    private final MeshInstancing instancing;
    private long visits;
    private int hidden;

    SceneNodes(GltfDocument document, List<Note> notes) {
        this.document = document;
        this.notes = notes;
        instancing = new MeshInstancing(document);
    }

    /** All places of meshes, in the order of the nodes. */
    List<MeshInstance> instances() throws IOException {
        Deque<Visit> open = new ArrayDeque<>();
        pushReversed(open, roots(), Transform.IDENTITY);
        while (!open.isEmpty()) {
            Visit visit = open.pop();
            if (visit.node < 0) above.clear(~visit.node);
            else visit(visit, open);
        }
        instancing.report(notes);
        if (hidden > 0) notes.add(Note.dropped(NoteText.count(hidden, "hidden node") + " dropped.", hidden, ""));
        report();
        return instances;
    }

    private void visit(Visit visit, Deque<Visit> open) throws IOException {
        JsonNode node = document.element("nodes", visit.node, "node " + visit.node);
        if (above.get(visit.node)) throw document.error("node " + visit.node + " is below itself");
        visits += 1
                + node.path("children").size()
                + MeshInstancing.attributes(node).size();
        if (visits > MOST) throw tooMany();
        if (isHidden(node)) {
            hidden++;
            return;
        }
        Transform world = visit.parent.times(Transform.of(document, node, "node " + visit.node));
        if (JsonTree.isGiven(node.path("mesh"))) place(node, world, !seen.get(visit.node));
        seen.set(visit.node);
        above.set(visit.node);
        open.push(new Visit(~visit.node, null));
        pushReversed(open, numbers(node.path("children")), world);
    }

    private static boolean isHidden(JsonNode node) {
        JsonNode visible = node.path("extensions").path("KHR_node_visibility").path("visible");
        return visible.isBoolean() && !visible.booleanValue();
    }

    /** @param first whether no other way through the scene has led to the node */
    private void place(JsonNode node, Transform world, boolean first) throws IOException {
        JsonNode mesh = document.element("meshes", node.path("mesh"), "mesh");
        int number = JsonTree.index(node.path("mesh"));
        String name = node.path("name").asText();
        if (name.isBlank()) name = mesh.path("name").asText();
        name = name.isBlank() ? "" : document.names().fit(name);
        boolean morphed = isMorphed(node, mesh);
        boolean hasBytes = first && instancing.hasBytes(node);
        Transform place = isSkinned(node) ? Transform.IDENTITY : world;
        for (Transform local : instancing.transforms(node)) {
            if (instances.size() == MOST) throw tooMany();
            instances.add(new MeshInstance(number, place.times(local), name, morphed, hasBytes));
        }
    }

    private boolean isSkinned(JsonNode node) {
        int skin = JsonTree.index(node.path("skin"));
        return skin >= 0 && document.root().path("skins").path(skin).isObject();
    }

    private static boolean isMorphed(JsonNode node, JsonNode mesh) {
        JsonNode weights = node.path("weights").isArray() ? node.path("weights") : mesh.path("weights");
        int seen = 0;
        for (JsonNode weight : weights) {
            if (weight.asDouble() != 0) return true;
            if (++seen == MOST_WEIGHTS) break;
        }
        return false;
    }

    private ModelFormatException tooMany() {
        return document.error("the scene has more than " + MOST + " nodes", "Split the scene");
    }

    private void report() {
        BitSet meshes = new BitSet();
        int repeated = 0;
        for (MeshInstance instance : instances) {
            if (meshes.get(instance.mesh())) repeated++;
            meshes.set(instance.mesh());
        }
        if (repeated == 0) return;
        String text = NoteText.count(repeated, "repeat") + " of meshes expanded: each is stored by itself.";
        notes.add(Note.changed(text, repeated, ""));
    }

    private static void pushReversed(Deque<Visit> open, List<Integer> nodes, Transform parent) {
        for (int i = nodes.size() - 1; i >= 0; i--) open.push(new Visit(nodes.get(i), parent));
    }

    /** Numbers of nodes; nulls are left out. */
    private List<Integer> numbers(JsonNode list) throws ModelFormatException {
        List<Integer> numbers = new ArrayList<>();
        for (JsonNode number : list) {
            if (!JsonTree.isGiven(number)) continue;
            document.element("nodes", number, "node");
            numbers.add(JsonTree.index(number));
        }
        return numbers;
    }

    /** Nodes of the scene that the file shows; without scenes, all nodes that are no children. */
    private List<Integer> roots() throws ModelFormatException {
        JsonNode scenes = document.root().path("scenes");
        if (scenes.size() > 0) {
            if (scenes.size() > 1)
                notes.add(Note.unread("Of " + scenes.size() + " scenes one read.", scenes.size() - 1, ""));
            JsonNode shown = document.root().path("scene");
            return numbers(document.element("scenes", JsonTree.index(shown, 0), "scene " + shown.asText())
                    .path("nodes"));
        }
        JsonNode nodes = document.root().path("nodes");
        BitSet children = new BitSet();
        for (JsonNode node : nodes) {
            for (JsonNode child : node.path("children")) {
                int number = JsonTree.index(child);
                if (number >= 0 && number < nodes.size()) children.set(number);
            }
        }
        List<Integer> roots = new ArrayList<>();
        for (int n = 0; n < nodes.size(); n++) {
            if (!children.get(n) && !nodes.get(n).isNull()) roots.add(n);
        }
        return roots;
    }
}
