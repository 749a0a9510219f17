package org.jsmesh.files.gltf.write;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.display.LinearLight;
import org.jsmesh.display.Slot;
import org.jsmesh.display.TextureUse;
import org.jsmesh.files.gltf.json.ImageType;
import org.jsmesh.mesh.Material;

/** Says in glTF how a material of another format looks. */
final class MaterialTranslation {
    private static final int LINEAR = 9729;
    private static final int LINEAR_MIPMAP_LINEAR = 9987;

    private final ImageList images;
    private final TextureList textures;
    private final boolean vertexColours;
    private final Set<String> left = new TreeSet<>();

    /** @param vertexColours whether the mesh has colours by itself, which a material without colour shows */
    MaterialTranslation(ImageList images, TextureList textures, boolean vertexColours) {
        this.images = images;
        this.textures = textures;
        this.vertexColours = vertexColours;
    }

    /** Whether a translation has an image. */
    static boolean hasImage(JsonNode translation) {
        return translation.findValue("index") != null;
    }

    ObjectNode of(Material material, boolean withImages) {
        DisplayMaterial look = DisplayMaterial.of(material, vertexColours);
        ObjectNode json = JsonNodeFactory.instance.objectNode().put("name", material.name());
        ObjectNode pbr = json.putObject("pbrMetallicRoughness");
        boolean hidden = withImages && image(pbr, "baseColorTexture", look, Slot.COLOUR) != null;
        float[] colour = look.plain();
        // An image of MTL hides the colour below it; glTF multiplies the two.
        for (int i = 0; i < 3; i++) colour[i] = hidden ? 1 : linear(colour[i]);
        colour[3] = Math.max(0, Math.min(1, colour[3]));
        Numbers.add(pbr.putArray("baseColorFactor"), colour);
        // Without its image, a metal would be one all over.
        boolean metal = look.image(Slot.METALLIC) == null && look.metallic() > 0;
        pbr.set("metallicFactor", Numbers.number(metal ? look.metallic() : 0));
        if (look.roughness() >= 0) pbr.set("roughnessFactor", Numbers.number(look.roughness()));
        if (withImages) {
            ObjectNode normal = image(json, "normalTexture", look, Slot.NORMAL);
            float scale = normal == null ? 1 : look.textures().get(Slot.NORMAL).factor();
            if (scale != 1) normal.set("scale", Numbers.number(scale));
        }
        emit(json, look, withImages);
        if (colour[3] < 1) json.put("alphaMode", "BLEND");
        else if (hidden && ImageType.hasAlpha(images.bytes(look.image(Slot.COLOUR)))) json.put("alphaMode", "MASK");
        if (look.doubleSided()) json.put("doubleSided", true);
        left(look, Slot.OPACITY, "map_d");
        left(look, Slot.METALLIC, "map_Pm");
        left(look, Slot.ROUGHNESS, "map_Pr");
        left(look, Slot.BUMP, "map_Bump");
        return json;
    }

    private void emit(ObjectNode json, DisplayMaterial look, boolean withImages) {
        if (look.emission() == null) return;
        boolean shown = withImages && image(json, "emissiveTexture", look, Slot.EMISSION) != null;
        // Without its image, the light would be all over.
        if (look.image(Slot.EMISSION) != null && !shown) return;
        float[] light = new float[3];
        for (int i = 0; i < 3; i++) light[i] = linear(look.emission().get(i));
        Numbers.add(json.putArray("emissiveFactor"), light);
    }

    private void left(DisplayMaterial look, Slot slot, String key) {
        if (look.image(slot) != null) left.add(key);
    }

    /** The use of an image; null where there is none that glTF shows. */
    private ObjectNode image(ObjectNode holder, String key, DisplayMaterial look, Slot slot) {
        TextureUse use = look.textures().get(slot);
        int number = use == null ? -1 : textures.number(use.path(), sampler(use.sampler()));
        if (number < 0) return null;
        ObjectNode info = holder.putObject(key).put("index", number);
        if (use.set() != 0) info.put("texCoord", use.set());
        List<Float> t = use.transform();
        // glTF counts v from the top of an image, MTL from its bottom.
        ObjectNode transform = info.putObject("extensions").putObject("KHR_texture_transform");
        Numbers.add(transform.putArray("offset"), t.get(2), t.get(5));
        Numbers.add(transform.putArray("scale"), t.get(0), t.get(4));
        return info;
    }

    private static JsonNode sampler(TextureUse.Sampler given) {
        ObjectNode sampler = JsonNodeFactory.instance.objectNode();
        if (given.magFilter() != LINEAR) sampler.put("magFilter", given.magFilter());
        if (given.minFilter() != LINEAR_MIPMAP_LINEAR) sampler.put("minFilter", given.minFilter());
        if (given.wrapU() != 10497) sampler.put("wrapS", given.wrapU());
        if (given.wrapV() != 10497) sampler.put("wrapT", given.wrapV());
        return sampler;
    }

    private static float linear(float screen) {
        return (float) LinearLight.light(Math.max(0, Math.min(1, screen)));
    }

    void report(List<String> remarks) {
        if (!left.isEmpty())
            remarks.add("glTF has no such images by themselves, so the extras alone have them: "
                    + String.join(", ", left) + ".");
    }
}
