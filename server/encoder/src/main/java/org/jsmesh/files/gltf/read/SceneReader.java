package org.jsmesh.files.gltf.read;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import org.jsmesh.files.gltf.json.DroppedParts;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.io.ModelFile;
import org.jsmesh.mesh.io.ModelFormat;
import org.jsmesh.mesh.io.ModelFormatException;
import org.jsmesh.mesh.io.ResourceResolver;

/**
 * Reads glTF 2.0, GLB or JSON, as one mesh: every node of the scene is baked to world space in double arithmetic,
 * rounded once to float32, and seams are welded. Nodes without a transform keep every bit. Skins, morph targets and
 * animations are dropped and reported. What is used is checked, and nothing else.
 */
public final class SceneReader {
    private final GltfDocument document;
    private final List<Note> notes = new ArrayList<>();

    private SceneReader(GltfDocument document) {
        this.document = document;
    }

    /**
     * @param fileName for messages
     * @param content the whole file
     * @param resources finds the buffers and images that are not within the file
     * @param mostFaces that the model may have
     * @throws ModelFormatException when the content is not glTF 2.0 or damaged, or the model has more faces
     * @throws IOException when a resource cannot be read
     */
    public static ModelFile read(String fileName, byte[] content, ResourceResolver resources, int mostFaces)
            throws IOException {
        return new SceneReader(new GltfDocument(fileName, content, resources, mostFaces)).read();
    }

    private ModelFile read() throws IOException {
        GltfExtensions.check(document, notes);
        List<MeshInstance> instances = new SceneNodes(document, notes).instances();
        MeshBaker baker = new MeshBaker(document, notes);
        baker.bake(instances);
        int skins = document.root().path("skins").size();
        if (skins > 0) {
            String text = "Skins dropped: meshes are in the pose they were modelled in.";
            notes.add(Note.dropped(text, skins, "skin 0"));
        }
        int animations = document.root().path("animations").size();
        if (animations > 0) notes.add(Note.dropped("Animations dropped.", animations, "animation 0"));
        addParts();
        Mesh mesh = new GltfMaterials(document, notes)
                .addTo(baker.assembler(), baker.faceMaterials())
                .build();
        add(
                Note.Kind.CHANGED,
                "Names longer than an archive holds shortened",
                document.names().shortened());
        return new ModelFile(mesh, ModelFormat.GLB, notes);
    }

    /** Parts of the tree that no mesh has. */
    private void addParts() {
        JsonNode root = document.root();
        add(Note.Kind.DROPPED, "Cameras dropped", DroppedParts.cameras(root));
        add(Note.Kind.DROPPED, "Extras dropped", DroppedParts.extras(root));
        add(Note.Kind.DROPPED, "Metadata of the file dropped", DroppedParts.metadata(root));
    }

    private void add(Note.Kind kind, String text, Collection<String> names) {
        if (!names.isEmpty()) notes.add(NoteText.note(kind, text, names));
    }
}
