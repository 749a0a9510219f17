package org.jsmesh.files.gltf.read;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jsmesh.files.gltf.json.GltfExtras;
import org.jsmesh.files.gltf.json.JsonTree;
import org.jsmesh.files.gltf.json.OriginalMaterial;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.Texture;
import org.jsmesh.mesh.io.MeshAssembler;

/**
 * The materials that faces use, as glTF has them. A definition that the writer of GLB put into the extras of a material
 * takes precedence over its translation.
 */
final class GltfMaterials {
    private final GltfDocument document;
    private final List<Note> notes;
    private final GltfImages images;
    private final JsonCopies textures;
    private final JsonCopies samplers;
    private final MaterialRepairs repairs = new MaterialRepairs();
    private int missing;

    GltfMaterials(GltfDocument document, List<Note> notes) {
        this.document = document;
        this.notes = notes;
        images = new GltfImages(document);
        textures = new JsonCopies(document, "textures");
        samplers = new JsonCopies(document, "samplers");
    }

    /** Materials and textures, numbered by first use. */
    MeshAssembler addTo(MeshAssembler assembler, int[] faceMaterials) throws IOException {
        Map<Integer, Integer> ids = new LinkedHashMap<>();
        List<Material> materials = new ArrayList<>();
        int[] faces = new int[faceMaterials.length];
        Arrays.fill(faces, -1);
        for (int f = 0; f < faces.length; f++) {
            int gltfId = original(faceMaterials[f]);
            if (gltfId == -1) continue;
            Integer id = ids.get(gltfId);
            if (id == null) {
                id = isThere(gltfId) ? materials.size() : -1;
                ids.put(gltfId, id);
                if (id >= 0) materials.add(material(gltfId));
                else missing++;
            }
            faces[f] = id;
        }
        reportUnused(faceMaterials);
        return assembler.materials(faces, materials, images(materials));
    }

    private void reportUnused(int[] faceMaterials) {
        BitSet used = new BitSet();
        for (int id : faceMaterials) {
            if (id < 0) continue;
            used.set(id);
            used.set(original(id));
        }
        List<String> unused = new ArrayList<>();
        int size = document.root().path("materials").size();
        for (int id = used.nextClearBit(0); id < size; id = used.nextClearBit(id + 1))
            if (isThere(id)) unused.add(name(id));
        if (!unused.isEmpty())
            notes.add(NoteText.note(Note.Kind.DROPPED, "Materials that no face has dropped", unused));
    }

    private String name(int id) {
        JsonNode name = document.root().path("materials").path(id).path("name");
        return name.isTextual() ? name.asText() : "material" + id;
    }

    /** The material that a twin without images stands for. */
    private int original(int id) {
        JsonNode jsm = document.root()
                .path("materials")
                .path(Math.max(0, id))
                .path("extras")
                .path(GltfExtras.JSM);
        int same = JsonTree.index(jsm.path(GltfExtras.SAME_AS));
        return id >= 0 && same >= 0 && isThere(same) ? same : id;
    }

    private boolean isThere(int id) {
        return document.root().path("materials").path(id).isObject();
    }

    private List<Texture> images(List<Material> materials) throws IOException {
        Set<String> paths = new LinkedHashSet<>();
        for (Material material : materials) material.textures().forEach(t -> paths.add(t.path()));
        List<Texture> found = new ArrayList<>();
        List<String> absent = new ArrayList<>();
        for (String path : paths) {
            Optional<byte[]> bytes = images.bytes(path);
            bytes.ifPresentOrElse(b -> found.add(new Texture(path, b)), () -> absent.add(path));
        }
        absent.removeAll(images.damaged());
        if (!images.damaged().isEmpty()) {
            String text = "Images without bytes that can be read left out";
            notes.add(NoteText.note(Note.Kind.DROPPED, text, images.damaged()).asWarning());
        }
        if (missing > 0) {
            String text = NoteText.count(missing, "material") + " not in the file: faces without material instead.";
            notes.add(Note.dropped(text, missing, "").asWarning());
        }
        repairs.report(notes);
        if (!absent.isEmpty())
            notes.add(NoteText.note(
                            Note.Kind.DROPPED,
                            "Textures not found; put the images beside the model under these names and encode it again",
                            absent)
                    .asWarning());
        return found;
    }

    private Material material(int id) throws IOException {
        JsonNode given = document.root().path("materials").path(id);
        String name = document.names().fit(name(id));
        JsonNode jsm = given.path("extras").path(GltfExtras.JSM);
        if (!jsm.path(GltfExtras.PARAMETERS).isArray())
            return new MaterialDefinition(textures, samplers, images, repairs, document.names()).material(name, given);
        OriginalMaterial original = new OriginalMaterial(jsm);
        for (String dropped : original.dropped()) repairs.leftOut(name + ": " + dropped);
        return original.material(name);
    }
}
