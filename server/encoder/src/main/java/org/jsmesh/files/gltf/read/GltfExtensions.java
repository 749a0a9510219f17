package org.jsmesh.files.gltf.read;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.jsmesh.files.gltf.json.DroppedParts;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.io.ModelFormatException;

/** Tells which extensions a file uses that are not read here. */
final class GltfExtensions {
    /** Read, or kept in the definitions of materials. */
    private static final Set<String> READ = Set.of(
            "EXT_mesh_gpu_instancing",
            "EXT_texture_avif",
            "EXT_texture_webp",
            "KHR_mesh_quantization",
            "KHR_node_visibility",
            "KHR_texture_basisu",
            "KHR_texture_transform",
            "MSFT_texture_dds");

    /** They hide no mesh, and a file is shown without them. */
    private static final Set<String> DISPENSABLE = Set.of(
            "EXT_lights_ies",
            "EXT_lights_image_based",
            "KHR_animation_pointer",
            "KHR_lights_punctual",
            "KHR_materials_variants",
            "KHR_node_hoverability",
            "KHR_node_selectability",
            "KHR_xmp",
            "KHR_xmp_json_ld");

    /** Of materials: drawn here, or turned into what is drawn. A file that requires another one is refused. */
    private static final Set<String> DRAWN = Set.of(
            "EXT_materials_bump",
            "KHR_materials_anisotropy",
            "KHR_materials_clearcoat",
            "KHR_materials_diffuse_transmission",
            "KHR_materials_dispersion",
            "KHR_materials_emissive_strength",
            "KHR_materials_ior",
            "KHR_materials_iridescence",
            "KHR_materials_pbrSpecularGlossiness",
            "KHR_materials_sheen",
            "KHR_materials_specular",
            "KHR_materials_transmission",
            "KHR_materials_unlit",
            "KHR_materials_volume");

    /** Kept in the definitions of materials. */
    private static final String MATERIALS = "(KHR|EXT|ADOBE|MSFT|FB)_materials_.*";

    private GltfExtensions() {}

    /**
     * @param notes receives the extensions that are not read
     * @throws ModelFormatException when the file requires one of them
     */
    static void check(GltfDocument document, List<Note> notes) throws ModelFormatException {
        Set<String> required = names(document.root().path("extensionsRequired"));
        required.removeIf(
                name -> DRAWN.contains(name) || isRead(name) && !isOfMaterials(name) || DISPENSABLE.contains(name));
        if (!required.isEmpty()) {
            String what = "the file requires " + (required.size() == 1 ? "an extension" : "extensions")
                    + " of glTF that jSM does not read: " + NoteText.shown(required);
            throw document.error(what, "Export the model without it");
        }
        Set<String> unread = names(document.root().path("extensionsUsed"));
        unread.addAll(names(document.root().path("extensionsRequired")));
        unread.addAll(DroppedParts.extensions(document.root()));
        unread.removeIf(GltfExtensions::isRead);
        if (!unread.isEmpty()) notes.add(NoteText.note(Note.Kind.UNREAD, "Extensions not read", unread));
    }

    private static boolean isRead(String name) {
        return READ.contains(name) || isOfMaterials(name) || PackedMeshes.EXTENSIONS.contains(name);
    }

    private static boolean isOfMaterials(String name) {
        return name.matches(MATERIALS) && !DISPENSABLE.contains(name);
    }

    private static Set<String> names(JsonNode list) {
        Set<String> names = new TreeSet<>();
        for (JsonNode name : list) if (name.isTextual()) names.add(name.asText());
        return names;
    }
}
