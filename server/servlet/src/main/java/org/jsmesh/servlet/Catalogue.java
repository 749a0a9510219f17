package org.jsmesh.servlet;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.List;
import java.util.Locale;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.files.ArchiveParts;
import org.jsmesh.files.ModelBounds;
import org.jsmesh.servlet.http.Answer;
import org.jsmesh.store.Archive;
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
            case READY -> describe(model.entry().segment(), model.archive(), row);
            case PREPARING -> row.put("stage", model.stage()).put("fraction", model.fraction());
            case FAILED ->
                row.put("error", model.failure().getMessage())
                        .put("remedy", model.failure().remedy());
            default -> {
                // Nothing is known of a model that nobody has asked for.
            }
        }
    }

    private static void describe(String folder, Archive archive, ObjectNode row) {
        ArchiveHeader header = archive.header();
        String archiveUrl = folder + "/" + archive.sha256() + ".jsm";
        row.put("archiveUrl", archiveUrl).put("archiveSha256", archive.sha256());
        if (header.batches().poster() >= 0) row.put("posterUrl", ArchiveParts.url(archiveUrl, ArchiveParts.POSTER));
        row.put("meshSha256", header.meshSha256()).put("bytes", archive.bytes());
        row.put("faces", header.faces()).put("vertices", header.vertices());
        row.put("baseFaces", header.batches().faces(0))
                .put("baseBytes", header.batches().bytes(0));
        row.put("materials", header.materials().size())
                .put("textures", header.images().size());
        ArrayNode bounds = row.putArray("bounds");
        for (Number bound : ModelBounds.of(header)) {
            if (bound instanceof Float) bounds.add(bound.floatValue());
            else bounds.add(bound.doubleValue());
        }
    }
}
