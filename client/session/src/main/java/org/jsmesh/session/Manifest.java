package org.jsmesh.session;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.BatchIndexBuilder;
import org.jsmesh.archive.BatchKind;

/**
 * The parts of a manifest that a session needs.
 *
 * @param archive absolute address
 * @param archiveSha256 lower-case hexadecimal
 * @param meshSha256 lower-case hexadecimal
 * @param modelSha256 lower-case hexadecimal, or null when the manifest has none
 * @param index sizes of the batches, or null when the manifest has none
 */
record Manifest(URI archive, String archiveSha256, String meshSha256, String modelSha256, BatchIndex index) {
    private static final int LARGEST_BATCH = 1 << 30;

    static Manifest parse(URI location, byte[] json) throws FetchException {
        JsonNode root;
        try {
            root = new ObjectMapper().readTree(new String(json, StandardCharsets.UTF_8));
        } catch (JsonProcessingException e) {
            throw bad(location, "is no JSON");
        }
        if (root == null || !root.isObject()) throw bad(location, "is not a manifest");
        String url = root.path("archiveUrl").asText("");
        if (url.isEmpty()) throw bad(location, "names no archiveUrl");
        URI archive;
        try {
            archive = location.resolve(url);
        } catch (IllegalArgumentException e) {
            throw bad(location, "names an archiveUrl that is no address: " + url);
        }
        // A manifest must not make its reader open files or other protocols.
        if (!"http".equals(archive.getScheme()) && !"https".equals(archive.getScheme())) {
            throw bad(location, "names an archiveUrl that is neither http nor https: " + url);
        }
        return new Manifest(
                archive,
                hash(location, root, "archiveSha256"),
                hash(location, root, "meshSha256"),
                root.path("modelSha256").isTextual() ? hash(location, root, "modelSha256") : null,
                index(root.path("batches")));
    }

    private static String hash(URI location, JsonNode root, String name) throws FetchException {
        String value = root.path(name).asText("");
        if (!value.matches("[0-9a-f]{64}")) throw bad(location, "has no " + name + " of 64 hexadecimal digits");
        return value;
    }

    private static BatchIndex index(JsonNode rows) {
        if (!rows.isArray() || rows.isEmpty()) return null;
        BatchIndexBuilder builder = new BatchIndexBuilder();
        for (JsonNode row : rows) {
            long bytes = row.path("bytes").asLong(0);
            if (bytes < 1 || bytes > LARGEST_BATCH) return null;
            builder.add(BatchKind.SPLITS, (int) bytes, 0);
        }
        return builder.build();
    }

    private static FetchException bad(URI location, String what) {
        return FetchException.lasting(
                location.toString(), "the manifest " + what, "ask the publisher to write it again");
    }
}
