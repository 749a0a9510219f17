package org.jsmesh.servlet;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.List;
import java.util.Locale;
import org.jsmesh.files.ArchiveParts;
import org.jsmesh.servlet.http.Answer;
import org.jsmesh.store.ArchiveFacts;
import org.jsmesh.store.ModelStatus;

/** The list of models as JSON; {@code docs/protocol.md} describes its members. */
final class Catalogue {
    private Catalogue() {}

    static byte[] json(List<ModelStatus> models) throws IOException {
        ObjectNode root = Answer.JSON.createObjectNode();
        ArrayNode rows = root.putArray("models");
        for (ModelStatus model : models) describe(model, rows.addObject());
        return Answer.JSON.writeValueAsBytes(root);
    }

    private static void describe(ModelStatus model, ObjectNode row) {
        row.put("id", model.entry().id()).put("name", model.entry().name());
        row.put("format", model.entry().format()).put("fileBytes", model.entry().bytes());
        row.put("modified", model.entry().modified().toString());
        row.put("manifestUrl", model.entry().segment() + "/manifest.json");
        row.put("state", model.state().name().toLowerCase(Locale.ROOT));
        switch (model.state()) {
            case READY -> describe(model.entry().segment(), model.facts(), row);
            case PREPARING -> row.put("stage", model.stage()).put("fraction", model.fraction());
            case FAILED ->
                row.put("error", model.failure().getMessage())
                        .put("remedy", model.failure().remedy());
            default -> {
                // Nothing is known of a model that nobody has asked for.
            }
        }
    }

    private static void describe(String folder, ArchiveFacts facts, ObjectNode row) {
        String archiveUrl = folder + "/" + facts.sha256() + ".jsm";
        row.put("archiveUrl", archiveUrl).put("archiveSha256", facts.sha256());
        if (facts.hasPoster()) row.put("posterUrl", ArchiveParts.url(archiveUrl, ArchiveParts.POSTER));
        row.put("meshSha256", facts.meshSha256()).put("bytes", facts.bytes());
        row.put("faces", facts.faces()).put("vertices", facts.vertices());
        row.put("baseFaces", facts.baseFaces()).put("baseBytes", facts.baseBytes());
        row.put("materials", facts.materials()).put("textures", facts.textures());
        ArrayNode bounds = row.putArray("bounds");
        for (Number bound : facts.bounds()) {
            if (bound instanceof Float) bounds.add(bound.floatValue());
            else bounds.add(bound.doubleValue());
        }
    }
}
