package org.jsmesh.web;

import java.util.List;
import java.util.function.IntToDoubleFunction;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.ArchiveOpening;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.ChannelInfo;
import org.jsmesh.archive.OriginalWords;
import org.jsmesh.archive.Provenance;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.display.DisplaySlots;
import org.jsmesh.display.Slot;
import org.jsmesh.display.TextureUse;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;

/**
 * The parts of a header that the page needs, as JSON: totals, bounds, identity, the columns of the index, and the look
 * of each display slot.
 */
final class HeaderJson {
    private HeaderJson() {}

    /** All of it. */
    static void write(Json json, ArchiveOpening opening, ArchiveHeader header) {
        json.open('{').key("whole").flag(true);
        json.key("faces").number(header.faces());
        json.key("vertices").number(header.vertices());
        json.key("wedges").number(header.wedges());
        json.key("meshSha256").text(header.meshSha256());
        json.key("modelSha256").text(header.modelSha256());
        json.key("levels").number(header.levels().size());
        words(json, header.provenance());
        opening(json, opening, header.bounds(), header.batches());
    }

    /**
     * The same without words and identity, which the first decoder leaves to the whole one.
     *
     * @param header null before all of it is known: totals are null then, and bounds those of the box
     */
    static void writeFirst(Json json, ArchiveOpening opening, ArchiveHeader header, BatchIndex index) {
        boolean isWhole = header != null;
        json.open('{').key("whole").flag(isWhole);
        total(json, "faces", isWhole ? header.faces() : -1);
        total(json, "vertices", isWhole ? header.vertices() : -1);
        total(json, "wedges", isWhole ? header.wedges() : -1);
        total(json, "levels", isWhole ? header.levels().size() : -1);
        for (String late : new String[] {"meshSha256", "modelSha256", "words"})
            json.key(late).text(null);
        opening(json, opening, isWhole ? header.bounds() : opening.box(), index);
    }

    private static void total(Json json, String name, int value) {
        json.key(name);
        if (value < 0) json.text(null);
        else json.number(value);
    }

    private static void opening(Json json, ArchiveOpening opening, float[] bounds, BatchIndex index) {
        json.key("bounds").open('[');
        for (float bound : bounds) json.number(bound);
        json.close(']');
        json.key("origin").open('[');
        for (double from : opening.origin()) json.number(from);
        json.close(']');
        json.key("up").text(opening.up().label());
        json.key("isClosed").flag(opening.isClosed());
        channels(json, opening);
        boolean vertexColours = false;
        for (ChannelInfo channel : opening.channels()) vertexColours |= channel.semantic() == Channel.Semantic.COLOUR;
        slots(json, DisplaySlots.of(opening.materials(), vertexColours), vertexColours);
        index(json, index);
        json.close('}');
    }

    /** What to say of the original once it is proved. */
    private static void words(Json json, Provenance from) {
        json.key("words").open('{').key("claim").text(OriginalWords.claim(from));
        json.key("warning").flag(OriginalWords.hasWarning(from));
        json.key("notKept").text(OriginalWords.notKept(from)).close('}');
    }

    private static void channels(Json json, ArchiveOpening opening) {
        json.key("channels").open('[');
        for (ChannelInfo channel : opening.channels()) {
            json.open('{')
                    .key("semantic")
                    .text(channel.semantic().name())
                    .key("name")
                    .text(channel.name())
                    .close('}');
        }
        json.close(']');
    }

    private static void slots(Json json, DisplaySlots slots, boolean vertexColours) {
        json.key("slots").open('[');
        for (int s = 0; s < slots.size(); s++) {
            Material example = slots.example(s);
            json.open('{');
            if (example != null && example.isGltf()) gltf(json, example);
            else other(json, DisplayMaterial.ofOther(example, vertexColours));
            json.close('}');
        }
        json.close(']');
    }

    /** The definition is a text here: what an archive says may be no JSON. */
    private static void gltf(Json json, Material material) {
        json.key("gltf").text(material.gltf()).key("images").open('[');
        for (Material.TextureReference image : material.textures()) json.text(image.path());
        json.close(']');
    }

    private static void other(Json json, DisplayMaterial look) {
        numbers(json, "colour", look.colour());
        json.key("metallic").number(look.metallic()).key("roughness").number(look.roughness());
        numbers(json, "emission", look.emission());
        json.key("textures").open('{');
        for (Slot slot : Slot.values()) {
            TextureUse use = look.textures().get(slot);
            if (use == null) continue;
            json.key(slot.name()).open('{').key("path").text(use.path());
            json.key("clamped").flag(use.sampler().isClamped());
            numbers(json, "transform", use.transform());
            json.key("factor").number(use.factor()).close('}');
        }
        json.close('}');
    }

    private static void numbers(Json json, String key, List<Float> values) {
        json.key(key);
        if (values == null) {
            json.text(null);
            return;
        }
        json.open('[');
        for (float value : values) json.number(value);
        json.close(']');
    }

    private static void index(Json json, BatchIndex index) {
        json.key("archiveBytes").number(index.archiveBytes());
        column(json, "ends", index, index::end);
        column(json, "batchFaces", index, index::faces);
        column(json, "batchLevels", index, index::level);
        column(json, "precisionBits", index, index::precisionBits);
        column(json, "errorMeans", index, index::errorMean);
        column(json, "errorQuantiles", index, index::errorQuantile);
    }

    private static void column(Json json, String name, BatchIndex index, IntToDoubleFunction value) {
        json.key(name).open('[');
        for (int i = 0; i < index.size(); i++) json.number(value.applyAsDouble(i));
        json.close(']');
    }
}
