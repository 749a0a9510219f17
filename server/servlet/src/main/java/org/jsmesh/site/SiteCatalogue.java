package org.jsmesh.site;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import org.jsmesh.files.PathNames;
import org.jsmesh.store.ModelPage;
import org.jsmesh.store.ids.ModelIds;

/** The catalogue of a site, with the members that the servlet's has for archives that are ready. */
final class SiteCatalogue {
    static final String FIRST = "index.json";

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
     * Writes the pages of the catalogue. Those that were there before stay until the next time, for clients that are on
     * their way from one to the next.
     *
     * @param folder of all models
     * @param models folders of the models by their ids, in the order to list them in
     */
    static void write(Path folder, SortedMap<String, Path> models) throws IOException {
        Map<String, String> times = new HashMap<>();
        Set<String> named = new HashSet<>(before(folder, times));
        List<String> ids = List.copyOf(models.keySet());
        // The last page first, so that none names another that is not there yet.
        for (int start = (Math.max(0, ids.size() - 1) / ModelPage.MOST) * ModelPage.MOST; start >= 0; ) {
            int end = Math.min(ids.size(), start + ModelPage.MOST);
            ObjectNode page = JSON.createObjectNode();
            if (start == 0) page.put("total", ids.size());
            if (end < ids.size()) page.put("next", ModelPage.fileName(ModelIds.segment(ids.get(end - 1))));
            ArrayNode rows = page.putArray("models");
            for (String id : ids.subList(start, end)) describe(id, models.get(id), times, rows.addObject());
            String name = start == 0 ? FIRST : ModelPage.fileName(ids.get(start - 1));
            named.add(name);
            StaticSite.write(folder.resolve(name), JSON.writeValueAsBytes(page));
            start -= ModelPage.MOST;
        }
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, Files::isRegularFile)) {
            for (Path file : files) {
                String name = PathNames.name(file);
                if (ModelPage.after(name) != null && !named.contains(name)) Files.delete(file);
            }
        }
    }

    private static void describe(String id, Path model, Map<String, String> times, ObjectNode row) throws IOException {
        describe(id, manifest(model), row);
        String time = times.get(row.path("archiveSha256").asText());
        row.put("modified", time == null ? now(model) : time);
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

    /**
     * The names of the pages that are there.
     *
     * @param times is told when their archives were published, by hashes
     */
    private static List<String> before(Path folder, Map<String, String> times) throws IOException {
        List<String> names = new ArrayList<>();
        String name = FIRST;
        while (name != null && !names.contains(name)) {
            JsonNode page = read(folder.resolve(name));
            names.add(name);
            if (page == null) break;
            for (JsonNode row : page.path("models")) {
                if (row.has("modified"))
                    times.put(
                            row.path("archiveSha256").asText(),
                            row.path("modified").asText());
            }
            String next = page.path("next").asText("");
            String after = ModelPage.after(URLDecoder.decode(next, StandardCharsets.UTF_8));
            name = after == null || after.contains("/") ? null : ModelPage.fileName(after);
        }
        return names;
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
