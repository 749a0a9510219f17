package org.jsmesh.files.gltf.write;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.files.gltf.json.GltfExtras;
import org.jsmesh.files.gltf.json.JsonTree;
import org.jsmesh.files.gltf.json.TextureInfos;
import org.jsmesh.files.gltf.read.NoteText;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;

/**
 * The materials of a file. Definitions of glTF are written word for word, with their textures and samplers in the lists
 * of the file. Others are translated, and stay in the extras. A translation with images has a twin without any, for
 * faces that have no texture coordinates.
 */
final class MaterialList {
    private final ArrayNode materials = JsonNodeFactory.instance.arrayNode();
    private final List<Material> given;
    private final ImageList images;
    private final TextureList textures;
    private final ExtensionNames extensions;
    private final MaterialTranslation translation;
    private final Map<Integer, Integer> twins = new HashMap<>();
    private final List<String> damaged = new ArrayList<>();
    private boolean translated;

    MaterialList(Mesh mesh, BinaryChunk buffer, ExtensionNames extensions) throws IOException {
        this.extensions = extensions;
        given = mesh.materials();
        images = new ImageList(mesh.textures(), buffer);
        textures = new TextureList(images, extensions);
        boolean coloured = mesh.channel(Channel.Semantic.COLOUR) != null;
        translation = new MaterialTranslation(images, textures, coloured);
        for (Material material : given) materials.add(material.isGltf() ? lifted(material) : translated(material));
    }

    private ObjectNode lifted(Material material) throws IOException {
        ObjectNode json = JsonNodeFactory.instance.objectNode().put("name", material.name());
        JsonNode definition = definition(material);
        definition.properties().forEach(entry -> json.set(entry.getKey(), entry.getValue()));
        lift(json, material);
        extensions.use(json);
        return json;
    }

    private JsonNode definition(Material material) throws IOException {
        try {
            JsonNode definition = JsonTree.of(material.gltf());
            if (definition.isObject()) return definition;
        } catch (JsonProcessingException e) {
            // named below
        }
        damaged.add(material.name());
        return JsonNodeFactory.instance.objectNode();
    }

    /** Puts numbers in the places of textures. */
    private void lift(JsonNode part, Material material) {
        for (Map.Entry<String, JsonNode> entry : part.properties()) {
            if (entry.getKey().equals("extras")) continue;
            lift(entry.getValue(), material);
            if (TextureInfos.isSlot(entry.getKey(), entry.getValue())
                    && entry.getValue().get("index") instanceof ObjectNode texture)
                ((ObjectNode) entry.getValue()).put("index", textures.number(texture, material));
        }
        if (part.isArray()) part.forEach(element -> lift(element, material));
    }

    private ObjectNode translated(Material material) {
        translated = true;
        ObjectNode json = translation.of(material, true);
        extensions.use(json);
        ObjectNode jsm = json.putObject("extras").putObject(GltfExtras.JSM);
        ArrayNode parameters = jsm.putArray(GltfExtras.PARAMETERS);
        for (Material.Parameter p : material.parameters()) {
            ArrayNode parameter = parameters.addArray().add(p.key());
            for (float value : p.values()) parameter.add((double) value);
        }
        ArrayNode references = jsm.putArray(GltfExtras.TEXTURES);
        for (Material.TextureReference t : material.textures())
            references.addArray().add(t.key()).add(t.path());
        return json;
    }

    /** The number of a material for faces with or without texture coordinates. */
    int number(int material, boolean coordinates) {
        if (coordinates || given.get(material).isGltf() || !MaterialTranslation.hasImage(materials.get(material)))
            return material;
        Integer known = twins.get(material);
        if (known != null) return known;
        ObjectNode twin = translation.of(given.get(material), false);
        extensions.use(twin);
        twin.putObject("extras").putObject(GltfExtras.JSM).put(GltfExtras.SAME_AS, material);
        twins.put(material, materials.size());
        materials.add(twin);
        return materials.size() - 1;
    }

    void describe(ObjectNode gltf) {
        if (!materials.isEmpty()) gltf.set("materials", materials);
        textures.describe(gltf);
    }

    void report(List<String> notes, List<String> remarks) {
        if (!damaged.isEmpty())
            notes.add("Definitions of materials that are no JSON left out: " + NoteText.shown(damaged) + ".");
        if (images.hasOther())
            remarks.add("glTF shows only PNG, JPEG, WebP and KTX2 images; others are in the file, but most programs do"
                    + " not show them.");
        translation.report(remarks);
        if (translated)
            remarks.add("Materials of another format translated for glTF, their definitions kept in the extras.");
    }
}
