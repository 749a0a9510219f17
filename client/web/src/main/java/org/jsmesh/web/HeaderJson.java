package org.jsmesh.web;

import java.util.function.IntToDoubleFunction;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.ArchiveOpening;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.ChannelInfo;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.display.DisplaySlots;
import org.jsmesh.mesh.Channel;

/**
 * The parts of a header that the page needs, as JSON: totals, bounds, identity, the columns of the index, and the look
 * of each display slot.
 */
final class HeaderJson {
    private HeaderJson() {}

    /** @param header null while the opening alone has arrived: totals are then null, and bounds those of the box */
    static void write(Json json, ArchiveOpening opening, ArchiveHeader header) {
        json.open('{');
        json.key("whole").flag(header != null);
        if (header == null) {
            for (String total : new String[] {"faces", "vertices", "wedges", "meshSha256", "levels"})
                json.key(total).text(null);
        } else {
            json.key("faces").number(header.faces());
            json.key("vertices").number(header.vertices());
            json.key("wedges").number(header.wedges());
            json.key("meshSha256").text(header.meshSha256());
            json.key("levels").number(header.levels().size());
        }
        json.key("bounds").open('[');
        for (float bound : header == null ? opening.box() : header.bounds()) json.number(bound);
        json.close(']');
        channels(json, opening);
        boolean vertexColours = false;
        for (ChannelInfo channel : opening.channels()) vertexColours |= channel.semantic() == Channel.Semantic.COLOUR;
        slots(json, DisplaySlots.of(opening.materials(), vertexColours));
        index(json, header == null ? opening.batches() : header.batches());
        json.close('}');
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

    private static void slots(Json json, DisplaySlots slots) {
        json.key("slots").open('[');
        for (DisplayMaterial look : slots.materials()) {
            json.open('{').key("colour");
            if (look.colour() == null) {
                json.text(null);
            } else {
                json.open('[');
                for (float part : look.colour()) json.number(part);
                json.close(']');
            }
            json.key("texture").text(look.texture()).key("gltf").flag(look.gltf());
            json.key("metallic")
                    .number(look.metallic())
                    .key("roughness")
                    .number(look.roughness())
                    .close('}');
        }
        json.close(']');
    }

    private static void index(Json json, BatchIndex index) {
        json.key("archiveBytes").number(index.archiveBytes());
        column(json, "ends", index, index::end);
        column(json, "batchFaces", index, index::faces);
        column(json, "batchLevels", index, index::level);
        column(json, "precisionBits", index, index::precisionBits);
        column(json, "errorMeans", index, index::errorMean);
    }

    private static void column(Json json, String name, BatchIndex index, IntToDoubleFunction value) {
        json.key(name).open('[');
        for (int i = 0; i < index.size(); i++) json.number(value.applyAsDouble(i));
        json.close(']');
    }
}
