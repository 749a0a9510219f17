package org.jsmesh.files.gltf.read;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jsmesh.files.gltf.json.DefinitionLimits;
import org.jsmesh.files.gltf.json.JsonTree;
import org.jsmesh.files.gltf.json.LongNames;
import org.jsmesh.files.gltf.json.TextureInfos;
import org.jsmesh.mesh.Material;

/**
 * The definition of a material as the file has it, except that a texture stands where its number stood, with its
 * sampler, and that its images are numbered among the textures of the material.
 */
final class MaterialDefinition {
    private final JsonCopies textures;
    private final JsonCopies samplers;
    private final GltfImages images;
    private final MaterialRepairs repairs;
    private final LongNames names;
    private final List<Material.TextureReference> references = new ArrayList<>();

    /** Infos and textures that are in their places; by identity, as equal ones may be elsewhere. */
    private final Set<JsonNode> infos = Collections.newSetFromMap(new IdentityHashMap<>());

    private final Set<JsonNode> done = Collections.newSetFromMap(new IdentityHashMap<>());

    MaterialDefinition(
            JsonCopies textures, JsonCopies samplers, GltfImages images, MaterialRepairs repairs, LongNames names) {
        this.names = names;
        this.textures = textures;
        this.samplers = samplers;
        this.images = images;
        this.repairs = repairs;
    }

    Material material(String name, JsonNode given) throws IOException {
        ObjectNode definition = given.deepCopy();
        definition.remove("name");
        for (String dropped : DefinitionLimits.cut(definition)) repairs.tooLarge(name + ": " + dropped);
        repairs.repair(definition, name);
        for (String slot : List.of("normalTexture", "occlusionTexture", "emissiveTexture"))
            texture(definition, slot, slot);
        if (definition.path("pbrMetallicRoughness") instanceof ObjectNode pbr) {
            for (String slot : List.of("baseColorTexture", "metallicRoughnessTexture")) texture(pbr, slot, slot);
        }
        others(definition, "", false);
        return new Material(name, List.of(), references, definition.toString());
    }

    /** Textures that the core of glTF does not know, at any depth ({@link TextureInfos}). */
    private void others(JsonNode node, String prefix, boolean extensions) throws IOException {
        if (node instanceof ArrayNode array) {
            for (JsonNode element : array) others(element, prefix, false);
        }
        if (!(node instanceof ObjectNode object)) return;
        for (String key : keys(object)) {
            JsonNode value = object.get(key);
            if (key.equals("extras") || done.contains(value)) continue;
            if (TextureInfos.isSlot(key, value)) other(object, key, prefix + key);
            others(object.path(key), extensions ? key + "." : prefix, key.equals("extensions"));
        }
    }

    private void other(ObjectNode holder, String key, String slot) throws IOException {
        JsonNode index = holder.path(key).path("index");
        if (infos.contains(holder.get(key))) return;
        if (index.isObject()) {
            holder.remove(key); // in a definition it would be a texture
            repairs.leftOut(slot);
        } else if (index.isNumber() && index.doubleValue() == Math.rint(index.doubleValue())) {
            texture(holder, key, slot);
        }
    }

    private static List<String> keys(ObjectNode object) {
        List<String> keys = new ArrayList<>();
        object.fieldNames().forEachRemaining(keys::add);
        return keys;
    }

    /** Puts a texture in the place of its number. */
    private void texture(ObjectNode holder, String key, String slot) throws IOException {
        JsonNode info = holder.path(key);
        if (info.isMissingNode()) return;
        ObjectNode texture = textures.copy(info.path("index"));
        if (!(info instanceof ObjectNode changed) || texture == null) {
            holder.remove(key);
            repairs.withoutTexture(slot);
            return;
        }
        images(texture, slot);
        if (texture.has("sampler")) sampler(texture, slot);
        changed.set("index", texture);
        done.add(texture);
        infos.add(changed);
    }

    private void images(ObjectNode texture, String slot) throws IOException {
        int before = references.size();
        List<String> removed = new ArrayList<>();
        source(texture, slot, removed);
        for (Map.Entry<String, JsonNode> extension : texture.path("extensions").properties()) {
            String name = extension.getKey();
            if (TextureInfos.hasSource(name) && extension.getValue() instanceof ObjectNode object)
                source(object, slot + "." + name, removed);
        }
        if (references.size() == before) repairs.withoutImage(slot);
        else removed.forEach(repairs::leftOut);
    }

    private void source(ObjectNode texture, String slot, List<String> removed) throws IOException {
        if (!texture.has("source")) return;
        String path = images.path(JsonTree.index(texture.path("source")));
        if (path == null) {
            texture.remove("source");
            removed.add(slot + ".source");
            return;
        }
        texture.put("source", references.size());
        references.add(new Material.TextureReference(names.fit(slot), path));
    }

    private void sampler(ObjectNode texture, String slot) throws IOException {
        ObjectNode sampler = samplers.copy(texture.path("sampler"));
        if (sampler != null) {
            repairs.repairSampler(sampler, slot);
            texture.set("sampler", sampler);
        } else {
            texture.remove("sampler");
            repairs.leftOut(slot + ".sampler");
        }
    }
}
