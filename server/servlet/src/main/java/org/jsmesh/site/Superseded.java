package org.jsmesh.site;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import org.jsmesh.objects.ObjectContent;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.Upload;

/**
 * Keeps account of what an update replaces, in objects beside the catalogue, so that {@link CleanUp} need not look for
 * it.
 */
final class Superseded {
    private static final int MOST_IN_LIST = 2000;

    private final ObjectStore store;
    private final Instant now;
    private final ObjectNode list = CatalogueJson.JSON.createObjectNode();
    private final List<CatalogueRoot.Old> lists = new ArrayList<>();

    Superseded(ObjectStore store, Instant now) {
        this.store = store;
        this.now = now;
    }

    void page(String file) throws IOException {
        list.withArrayProperty("pages").add(file);
        writeFull();
    }

    /** A row has changed. */
    void replaced(CatalogueRow old, CatalogueRow row) throws IOException {
        String archive = CatalogueJson.archive(old.json());
        if (!row.isRemoval() && (archive.isEmpty() || archive.equals(CatalogueJson.archive(row.json())))) return;
        list.withArrayProperty(row.isRemoval() ? "models" : "archives")
                .addArray()
                .add(old.id())
                .add(archive);
        writeFull();
    }

    private void writeFull() throws IOException {
        int size = 0;
        for (JsonNode kind : list) size += kind.size();
        if (size >= MOST_IN_LIST) write();
    }

    private void write() throws IOException {
        if (list.isEmpty()) return;
        byte[] content = CatalogueJson.JSON.writeValueAsBytes(list);
        list.removeAll();
        // Two writers who replace the same do not share a list: one of them undoes it.
        String file = "superseded-" + UUID.randomUUID() + ".json";
        store.put(
                Upload.of("m/" + file, ObjectContent.of(content)).withHeaders(SiteHeaders.JSON, SiteHeaders.FOR_EVER));
        lists.add(new CatalogueRoot.Old(now.toString(), file));
    }

    /** The lists of what this update replaces. */
    List<CatalogueRoot.Old> lists() throws IOException {
        write();
        return lists;
    }

    /** The update was not made. */
    void undo() throws IOException {
        for (CatalogueRoot.Old own : lists) store.delete("m/" + own.file());
    }
}
