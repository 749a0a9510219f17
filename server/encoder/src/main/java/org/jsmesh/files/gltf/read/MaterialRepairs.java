package org.jsmesh.files.gltf.read;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import org.jsmesh.files.gltf.json.JsonNumber;
import org.jsmesh.files.gltf.json.JsonTree;
import org.jsmesh.mesh.Note;

/**
 * Puts values of materials right that glTF does not allow, and counts them: numbers out of range are clamped, and what
 * is of another kind is left out, so that its default holds.
 */
final class MaterialRepairs {
    /** A difference that nobody sees. */
    private static final double UNSEEN = 1 / 510.0;

    private static final Set<String> ALPHA_MODES = Set.of("OPAQUE", "MASK", "BLEND");
    private static final Set<Integer> WRAPS = Set.of(33071, 33648, 10497);
    private static final Set<Integer> MAGNIFICATIONS = Set.of(9728, 9729);
    private static final Set<Integer> MINIFICATIONS = Set.of(9728, 9729, 9984, 9985, 9986, 9987);

    private final List<String> clamped = new ArrayList<>();
    private final Set<String> withoutImage = new TreeSet<>();
    private final Set<String> withoutTexture = new TreeSet<>();
    private final List<String> tooLarge = new ArrayList<>();
    private final List<String> leftOut = new ArrayList<>();
    private final List<String> respelled = new ArrayList<>();
    private boolean seen; // is one of the clamped values drawn in another way?

    /** Puts the values of a material right, those of its textures apart. */
    void repair(ObjectNode material, String name) {
        String of = name + ": ";
        alphaMode(material, of);
        number(material, "alphaCutoff", 0, Double.MAX_VALUE, of);
        numbers(material, "emissiveFactor", 3, of);
        if (material.has("doubleSided") && !material.get("doubleSided").isBoolean()) drop(material, "doubleSided", of);
        if (object(material, "pbrMetallicRoughness", of) instanceof ObjectNode pbr) {
            numbers(pbr, "baseColorFactor", 4, of);
            number(pbr, "metallicFactor", 0, 1, of);
            number(pbr, "roughnessFactor", 0, 1, of);
            info(pbr, "baseColorTexture", of);
            info(pbr, "metallicRoughnessTexture", of);
        }
        info(material, "emissiveTexture", of);
        if (info(material, "normalTexture", of) instanceof ObjectNode normal)
            number(normal, "scale", -Double.MAX_VALUE, Double.MAX_VALUE, of + "normalTexture.");
        if (info(material, "occlusionTexture", of) instanceof ObjectNode occlusion)
            number(occlusion, "strength", 0, 1, of + "occlusionTexture.");
        object(material, "extensions", of);
    }

    /** Puts the values of a sampler right. */
    void repairSampler(ObjectNode sampler, String slot) {
        String of = slot + ".sampler.";
        code(sampler, "wrapS", WRAPS, of);
        code(sampler, "wrapT", WRAPS, of);
        code(sampler, "magFilter", MAGNIFICATIONS, of);
        code(sampler, "minFilter", MINIFICATIONS, of);
    }

    private void code(ObjectNode sampler, String key, Set<Integer> known, String of) {
        if (sampler.has(key) && !known.contains(JsonTree.index(sampler.get(key)))) drop(sampler, key, of);
    }

    private void alphaMode(ObjectNode material, String of) {
        if (!material.has("alphaMode")) return;
        String given = material.get("alphaMode").asText();
        String mode = given.toUpperCase(Locale.ROOT);
        if (!ALPHA_MODES.contains(mode)) {
            drop(material, "alphaMode", of);
        } else if (!mode.equals(given)) {
            material.put("alphaMode", mode);
            respelled.add(of + given);
        }
    }

    private JsonNode info(ObjectNode holder, String key, String of) {
        JsonNode info = object(holder, key, of);
        if (info instanceof ObjectNode object && object.has("texCoord") && JsonTree.index(object.get("texCoord")) < 0)
            drop(object, "texCoord", of + key + ".");
        return info;
    }

    private JsonNode object(ObjectNode holder, String key, String of) {
        if (holder.has(key) && !holder.get(key).isObject()) drop(holder, key, of);
        return holder.path(key);
    }

    private void numbers(ObjectNode holder, String key, int size, String of) {
        if (!holder.has(key)) return;
        JsonNode given = holder.get(key);
        boolean fits = given.isArray() && given.size() == size;
        for (JsonNode number : given) fits &= number.isNumber();
        if (!fits) {
            drop(holder, key, of);
            return;
        }
        ArrayNode numbers = (ArrayNode) given;
        for (int i = 0; i < size; i++) {
            double value = numbers.get(i).asDouble();
            double right = clamp(value, 0, 1, of + key);
            if (right != value) numbers.set(i, new JsonNumber(right == 0 ? "0" : "1"));
        }
    }

    private void number(ObjectNode holder, String key, double low, double high, String of) {
        if (!holder.has(key)) return;
        JsonNode given = holder.get(key);
        if (!given.isNumber()) {
            drop(holder, key, of);
            return;
        }
        double right = clamp(given.asDouble(), low, high, of + key);
        if (right == given.asDouble()) return;
        holder.set(key, new JsonNumber(right == 0 ? "0" : right == 1 ? "1" : Double.toString(right)));
    }

    private double clamp(double value, double low, double high, String what) {
        double right = Math.max(low, Math.min(high, value));
        if (right != value) {
            clamped.add(what);
            seen |= Math.abs(right - value) > UNSEEN;
        }
        return right;
    }

    private void drop(ObjectNode holder, String key, String of) {
        holder.remove(key);
        leftOut(of + key);
    }

    /** Counts a value of another kind than glTF's. */
    void leftOut(String what) {
        leftOut.add(what);
    }

    /** Counts a part that is larger than an archive holds. */
    void tooLarge(String what) {
        tooLarge.add(what);
    }

    /** Counts a texture that the file does not have. */
    void withoutTexture(String slot) {
        withoutTexture.add(slot);
    }

    /** Counts a texture that has no image. */
    void withoutImage(String slot) {
        withoutImage.add(slot);
    }

    void report(List<Note> notes) {
        if (!withoutImage.isEmpty()) {
            notes.add(NoteText.note(Note.Kind.DROPPED, "Textures without an image in a known format", withoutImage)
                    .asWarning());
        }
        if (!withoutTexture.isEmpty()) {
            notes.add(NoteText.note(Note.Kind.DROPPED, "Textures that the file does not have left out", withoutTexture)
                    .asWarning());
        }
        if (!clamped.isEmpty()) {
            Note note = NoteText.note(Note.Kind.CHANGED, "Values of materials out of range clamped", clamped);
            notes.add(seen ? note.asWarning() : note);
        }
        if (!respelled.isEmpty())
            notes.add(NoteText.note(Note.Kind.REPAIRED, "Alpha modes written in capitals", respelled));
        if (!tooLarge.isEmpty()) {
            String text = "Parts of materials that are larger or deeper than an archive holds dropped";
            notes.add(NoteText.note(Note.Kind.DROPPED, text, tooLarge));
        }
        if (!leftOut.isEmpty())
            notes.add(
                    NoteText.note(Note.Kind.DROPPED, "Values of materials that glTF does not know left out", leftOut));
    }
}
