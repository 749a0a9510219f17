package org.jsmesh.site;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jsmesh.objects.ObjectConflictException;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;
import org.jsmesh.store.ModelPage;

/**
 * The one object of a catalogue that changes.
 *
 * @param object as it was found; null when there is none
 * @param generation grows with each version that names pages
 * @param rows of the first models
 * @param pages of the others, in order
 * @param superseded objects that list what was replaced, with the times
 */
record CatalogueRoot(
        StoredObject object, long generation, List<CatalogueRow> rows, List<Page> pages, List<Old> superseded) {
    static final String KEY = "m/index.json";
    private static final int MOST_TRIES = 100;

    /**
     * A page.
     *
     * @param first id on it
     * @param count of its models
     * @param file address, relative to the root's
     */
    record Page(String first, int count, String file) {
        /** Old pages are named after ids, whose letters addresses have encoded. */
        String key() {
            return "m/" + java.net.URLDecoder.decode(file, StandardCharsets.UTF_8);
        }
    }

    /**
     * What was replaced.
     *
     * @param time ISO 8601
     * @param file that lists it, relative to the root's address
     */
    record Old(String time, String file) {}

    long total() {
        return rows.size() + pages.stream().mapToLong(Page::count).sum();
    }

    static CatalogueRoot read(ObjectStore store) throws IOException {
        for (int i = 1; ; i++) {
            try {
                return readOnce(store);
            } catch (ObjectConflictException e) {
                // Somebody has written a newer one since it was found.
                if (i == MOST_TRIES) throw e;
            }
        }
    }

    private static CatalogueRoot readOnce(ObjectStore store) throws IOException {
        StoredObject object = store.find(KEY).orElse(null);
        if (object == null) return new CatalogueRoot(null, 0, List.of(), List.of(), List.of());
        ByteBuffer content = ByteBuffer.allocate(Math.toIntExact(object.bytes()));
        store.read(object, 0, content);
        String address = store.address() + "/" + KEY;
        List<CatalogueRow> rows = CatalogueJson.rows(content.array(), address);
        JsonNode root;
        try {
            root = CatalogueJson.JSON.readTree(content.array());
        } catch (JsonProcessingException e) {
            throw new NoCatalogueException(address, e);
        }
        List<Page> pages = new ArrayList<>();
        for (JsonNode page : root.path("pages"))
            pages.add(new Page(
                    page.path(0).asText(), page.path(1).asInt(), page.path(2).asText()));
        if (pages.isEmpty() && root.has("next")) chain(store, root.path("next").asText(), pages);
        List<Old> superseded = new ArrayList<>();
        for (JsonNode old : root.path("superseded"))
            superseded.add(new Old(old.path(0).asText(), old.path(1).asText()));
        return new CatalogueRoot(object, root.path("generation").asLong(), rows, pages, superseded);
    }

    /** Pages that name the next one each, as earlier versions wrote them. */
    private static void chain(ObjectStore store, String first, List<Page> pages) throws IOException {
        Set<String> met = new HashSet<>();
        for (String file = first; !file.isEmpty() && met.add(file); ) {
            Page page = new Page("", 0, file);
            byte[] content;
            try (var in = store.open(page.key())) {
                content = in.readAllBytes();
            }
            List<CatalogueRow> rows = CatalogueJson.rows(content, store.address() + "/" + page.key());
            if (!rows.isEmpty()) pages.add(new Page(rows.get(0).id(), rows.size(), file));
            file = CatalogueJson.JSON.readTree(content).path("next").asText("");
        }
    }

    byte[] toJson() throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream(1 << 17);
        StringBuilder head = new StringBuilder("{\"total\":").append(total());
        if (!pages.isEmpty())
            head.append(",\"next\":").append(quoted(pages.get(0).file()));
        write(out, head.append(",\"models\":[").toString());
        writeRows(out, rows);
        StringBuilder end = new StringBuilder("]");
        if (!pages.isEmpty()) {
            end.append(",\"pages\":[");
            String comma = "";
            for (Page page : pages) {
                end.append(comma).append('[').append(quoted(page.first())).append(',');
                end.append(page.count()).append(',').append(quoted(page.file())).append(']');
                comma = ",";
            }
            end.append(']');
        }
        if (generation > 0) end.append(",\"generation\":").append(generation);
        if (!superseded.isEmpty()) {
            end.append(",\"superseded\":[");
            String comma = "";
            for (Old old : superseded) {
                end.append(comma).append('[').append(quoted(old.time())).append(',');
                end.append(quoted(old.file())).append(']');
                comma = ",";
            }
            end.append(']');
        }
        write(out, end.append('}').toString());
        return out.toByteArray();
    }

    static byte[] page(List<CatalogueRow> rows) {
        ByteArrayOutputStream out = new ByteArrayOutputStream(700 * Math.min(rows.size(), ModelPage.MOST));
        write(out, "{\"models\":[");
        writeRows(out, rows);
        write(out, "]}");
        return out.toByteArray();
    }

    private static void writeRows(ByteArrayOutputStream out, List<CatalogueRow> rows) {
        for (int i = 0; i < rows.size(); i++) {
            if (i > 0) out.write(',');
            write(out, rows.get(i).json());
        }
    }

    private static void write(ByteArrayOutputStream out, String text) {
        out.writeBytes(text.getBytes(StandardCharsets.UTF_8));
    }

    private static String quoted(String text) throws IOException {
        return CatalogueJson.JSON.writeValueAsString(text);
    }
}
