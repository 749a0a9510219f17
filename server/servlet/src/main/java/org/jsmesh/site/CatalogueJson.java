package org.jsmesh.site;

import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.store.ids.ModelIds;

/** Rows of catalogues as JSON. */
final class CatalogueJson {
    static final ObjectMapper JSON = new ObjectMapper();

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

    private CatalogueJson() {}

    /** What the catalogue says of a model. */
    static CatalogueRow row(String id, String manifest, String modified) throws IOException {
        JsonNode of = JSON.readTree(manifest);
        ObjectNode row = JSON.createObjectNode();
        String place = ModelIds.segment(id);
        row.put("id", id).put("name", of.path("name").asText(id)).put("format", "jsm");
        row.put("fileBytes", of.path("bytes").asLong()).put("manifestUrl", place + "/manifest.json");
        row.put("state", "ready");
        row.put("archiveUrl", place + "/" + of.path("archiveUrl").asText());
        if (of.has("posterUrl"))
            row.put("posterUrl", place + "/" + of.path("posterUrl").asText());
        for (String member : OF_THE_ARCHIVE) row.set(member, of.path(member));
        row.put("modified", modified);
        return new CatalogueRow(id, row.toString());
    }

    /** The hash of the archive that a row names; empty when it is none. */
    static String archive(String row) throws IOException {
        String hash = JSON.readTree(row).path("archiveSha256").asText();
        return hash.matches("[0-9a-f]{64}") ? hash : "";
    }

    /**
     * A row that takes the place of another. The model keeps the time of its publication when its archive stays.
     *
     * @param before null when there was none
     */
    static String merge(String before, String after) throws IOException {
        if (before == null || before.equals(after)) return after;
        JsonNode old = JSON.readTree(before);
        JsonNode row = JSON.readTree(after);
        boolean isSame = old.path("archiveSha256").equals(row.path("archiveSha256"));
        if (!isSame || !old.has("modified") || !row.isObject()) return after;
        ((ObjectNode) row).set("modified", old.get("modified"));
        // What was read and written does not differ in spelling from what was written before.
        return row.toString();
    }

    /** The elements of {@code models}, as they are written. */
    static List<CatalogueRow> rows(byte[] page, String address) throws IOException {
        List<CatalogueRow> rows = new ArrayList<>();
        try (JsonParser json = JSON.createParser(page)) {
            if (json.nextToken() != JsonToken.START_OBJECT) throw new NoCatalogueException(address, null);
            while (json.nextToken() == JsonToken.FIELD_NAME) {
                boolean isModels = json.currentName().equals("models");
                if (json.nextToken() != JsonToken.START_ARRAY || !isModels) {
                    json.skipChildren();
                    continue;
                }
                while (json.nextToken() == JsonToken.START_OBJECT) rows.add(row(page, json, address));
            }
        } catch (JsonProcessingException e) {
            throw new NoCatalogueException(address, e);
        }
        return rows;
    }

    private static CatalogueRow row(byte[] page, JsonParser json, String address) throws IOException {
        int from = (int) json.currentTokenLocation().getByteOffset();
        String id = null;
        while (json.nextToken() == JsonToken.FIELD_NAME) {
            boolean isId = json.currentName().equals("id");
            json.nextToken();
            if (isId) id = json.getText();
            json.skipChildren();
        }
        int to = (int) json.currentTokenLocation().getByteOffset() + 1;
        if (id == null) throw new NoCatalogueException(address, null);
        return new CatalogueRow(id, new String(page, from, to - from, StandardCharsets.UTF_8));
    }
}
