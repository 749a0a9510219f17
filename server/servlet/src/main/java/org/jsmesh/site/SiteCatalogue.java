package org.jsmesh.site;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;

/** The catalogue of a site, with the members that the servlet's has for archives that are ready. */
final class SiteCatalogue {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final List<String> OF_THE_ARCHIVE = List.of(
            "archiveSha256",
            "meshSha256",
            "bytes",
            "faces",
            "vertices",
            "baseFaces",
            "baseBytes",
            "materials",
            "textures",
            "bounds");

    private SiteCatalogue() {}

    /**
     * @param models folder of the models
     * @param ids of those to list, in their order
     */
    static byte[] json(Path models, Iterable<String> ids) throws IOException {
        ObjectNode root = JSON.createObjectNode();
        ArrayNode rows = root.putArray("models");
        for (String id : ids) describe(id, manifest(models, id), rows.addObject());
        return JSON.writeValueAsBytes(root);
    }

    private static void describe(String id, JsonNode manifest, ObjectNode row) {
        row.put("id", id).put("name", manifest.path("name").asText(id)).put("format", "jsm");
        row.put("fileBytes", manifest.path("bytes").asLong()).put("manifestUrl", id + "/manifest.json");
        row.put("state", "ready");
        row.put("archiveUrl", id + "/" + manifest.path("archiveUrl").asText());
        for (String member : OF_THE_ARCHIVE) row.set(member, manifest.path(member));
    }

    /** The manifest of a model, or null when there is none that names an archive beside it. */
    static JsonNode manifest(Path models, String id) throws IOException {
        Path folder = models.resolve(id);
        JsonNode manifest;
        try {
            manifest = JSON.readTree(Files.readAllBytes(folder.resolve("manifest.json")));
        } catch (NoSuchFileException | com.fasterxml.jackson.core.JsonProcessingException e) {
            return null;
        }
        String archive = manifest.path("archiveUrl").asText();
        return archive.matches("[0-9a-f]{64}\\.jsm") && Files.isRegularFile(folder.resolve(archive)) ? manifest : null;
    }
}
