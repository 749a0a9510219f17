package org.jsmesh.site;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.NoSuchFileException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.UUID;
import org.jsmesh.objects.ObjectContent;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.Upload;

/**
 * Keeps account of what an update replaces, in objects beside the catalogue, and removes what was replaced more than a
 * day ago. So nothing has to be looked for.
 */
final class Superseded {
    private static final int MOST_IN_LIST = 2000;
    /** A run does not clean up for ever; the next one goes on. */
    private static final int MOST_LISTS = 20;

    private final ObjectStore store;
    private final Instant now;
    private final ObjectNode list = CatalogueJson.JSON.createObjectNode();
    private final List<CatalogueRoot.Old> lists = new ArrayList<>();
    private final List<String> done = new ArrayList<>();

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

    /** The update was made, and names the lists no more that were gone through. */
    void forget() throws IOException {
        for (String file : done) store.delete("m/" + file);
    }

    /**
     * Removes what was replaced long ago.
     *
     * @param pages files of those that stay
     * @return the lists that are still needed
     */
    List<CatalogueRoot.Old> removeOld(CatalogueRoot root, Set<String> pages) throws IOException {
        for (CatalogueRoot.Page page : root.pages()) pages.add(page.file());
        CatalogueReader catalogue = new CatalogueReader(store, root);
        List<CatalogueRoot.Old> kept = new ArrayList<>();
        for (CatalogueRoot.Old old : root.superseded()) {
            boolean isOld = Duration.between(Instant.parse(old.time()), now).compareTo(OldArchives.KEPT) > 0;
            if (!isOld || done.size() == MOST_LISTS) {
                kept.add(old);
                continue;
            }
            removeOld(old.file(), catalogue, pages);
            done.add(old.file());
        }
        return kept;
    }

    private void removeOld(String file, CatalogueReader catalogue, Set<String> pages) throws IOException {
        JsonNode all;
        try (InputStream in = store.open("m/" + file)) {
            all = CatalogueJson.JSON.readTree(in);
        } catch (NoSuchFileException e) {
            return; // Somebody else was quicker.
        }
        for (JsonNode page : all.path("pages")) {
            if (!pages.contains(page.asText())) store.delete(new CatalogueRoot.Page("", 0, page.asText()).key());
        }
        for (JsonNode archive : all.path("archives")) {
            String id = archive.path(0).asText();
            String hash = archive.path(1).asText();
            // It may have come back.
            if (!manifest(id).path("archiveSha256").asText().equals(hash)) removeArchive(store, id, hash);
        }
        for (JsonNode model : all.path("models")) {
            String id = model.path(0).asText();
            if (catalogue.find(id) == null) removeModel(store, id, model.path(1).asText());
        }
    }

    private JsonNode manifest(String id) throws IOException {
        try (InputStream in = store.open("m/" + id + "/manifest.json")) {
            return CatalogueJson.JSON.readTree(in);
        } catch (NoSuchFileException e) {
            return CatalogueJson.JSON.missingNode();
        }
    }

    private static void removeArchive(ObjectStore store, String id, String hash) throws IOException {
        for (String key : ModelKeys.archive(id, hash)) store.delete(key);
    }

    /** Removes all objects of a model that is in the catalogue no more, but for archives that it had before. */
    static void removeModel(ObjectStore store, String id, String hash) throws IOException {
        for (String key : ModelKeys.pages(id)) store.delete(key);
        if (!hash.isEmpty()) removeArchive(store, id, hash);
    }
}
