package org.jsmesh.site;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import org.jsmesh.store.ModelIds;

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
     * @param models folders of the models by their ids, in the order to list them in
     * @param before the catalogue that is there, which knows when the models were published that it has
     */
    static byte[] json(SortedMap<String, Path> models, Path before) throws IOException {
        Map<String, String> times = times(before);
        ObjectNode root = JSON.createObjectNode();
        ArrayNode rows = root.putArray("models");
        for (Map.Entry<String, Path> model : models.entrySet()) {
            ObjectNode row = rows.addObject();
            describe(model.getKey(), manifest(model.getValue()), row);
            String time = times.get(row.path("archiveSha256").asText());
            row.put("modified", time == null ? now(model.getValue()) : time);
        }
        return JSON.writeValueAsBytes(root);
    }

    private static void describe(String id, JsonNode manifest, ObjectNode row) {
        String place = ModelIds.segment(id);
        row.put("id", id).put("name", manifest.path("name").asText(id)).put("format", "jsm");
        row.put("fileBytes", manifest.path("bytes").asLong()).put("manifestUrl", place + "/manifest.json");
        row.put("state", "ready");
        row.put("archiveUrl", place + "/" + manifest.path("archiveUrl").asText());
        if (manifest.has("posterUrl"))
            row.put("posterUrl", place + "/" + manifest.path("posterUrl").asText());
        for (String member : OF_THE_ARCHIVE) row.set(member, manifest.path(member));
    }

    /** When archives of a catalogue were published, by their hashes. */
    private static Map<String, String> times(Path catalogue) throws IOException {
        Map<String, String> times = new HashMap<>();
        JsonNode before = read(catalogue);
        if (before == null) return times;
        for (JsonNode row : before.path("models")) {
            if (row.has("modified"))
                times.put(
                        row.path("archiveSha256").asText(), row.path("modified").asText());
        }
        return times;
    }

    /** When the manifest of a model was written. */
    private static String now(Path folder) throws IOException {
        Instant written =
                Files.getLastModifiedTime(folder.resolve("manifest.json")).toInstant();
        return written.truncatedTo(ChronoUnit.SECONDS).toString();
    }

    /** The manifest of a model, or null when there is none that names an archive beside it. */
    static JsonNode manifest(Path folder) throws IOException {
        JsonNode manifest = read(folder.resolve("manifest.json"));
        if (manifest == null) return null;
        String archive = manifest.path("archiveUrl").asText();
        return archive.matches("[0-9a-f]{64}\\.jsm") && Files.isRegularFile(folder.resolve(archive)) ? manifest : null;
    }

    /** Null when there is no such file, or it is not JSON. */
    private static JsonNode read(Path file) throws IOException {
        try {
            return JSON.readTree(Files.readAllBytes(file));
        } catch (NoSuchFileException | JsonProcessingException e) {
            return null;
        }
    }
}
