package org.jsmesh.site;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.NoSuchFileException;
import java.time.DateTimeException;
import java.time.Duration;
import java.time.Instant;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;

/**
 * Removes what updates of a catalogue replaced more than a day ago, by the lists of {@link Superseded}. What was
 * written again since a list was stays: somebody is about to publish it. The times are compared by the store's clock.
 */
final class CleanUp {
    /** A run does not clean up for ever; the next one goes on. */
    private static final int MOST_LISTS = 20;

    private final ObjectStore store;
    private final CatalogueRoot root;
    private final CatalogueReader catalogue;
    private final Set<String> pages = new HashSet<>();

    /** @param root as it is in the store now */
    CleanUp(ObjectStore store, CatalogueRoot root) {
        this.store = store;
        this.root = root;
        catalogue = new CatalogueReader(store, root);
        for (CatalogueRoot.Page page : root.pages()) pages.add(page.file());
    }

    /**
     * Goes through old lists and removes them too.
     *
     * @param now by the clock of this machine, which tells what is not worth asking for
     * @param ahead how far the store's clock is before that
     * @return files of the lists, which the root names in vain then
     */
    Set<String> run(Instant now, Duration ahead) throws IOException {
        Set<String> done = new HashSet<>();
        for (CatalogueRoot.Old old : root.superseded()) {
            if (done.size() == MOST_LISTS) break;
            if (!isOld(old, now)) continue;
            String key = "m/" + old.file();
            StoredObject list = store.find(key).orElse(null);
            if (list != null) {
                // The clock of who wrote it may have been slow.
                if (!isOld(list.modified(), now.plus(ahead))) continue;
                remove(key, list.modified());
                store.delete(key);
            }
            done.add(old.file());
        }
        return done;
    }

    private static boolean isOld(CatalogueRoot.Old old, Instant now) {
        try {
            return isOld(Instant.parse(old.time()), now);
        } catch (DateTimeException e) {
            return false; // Nobody knows how old it is.
        }
    }

    private static boolean isOld(Instant time, Instant now) {
        return Duration.between(time, now).compareTo(OldArchives.KEPT) > 0;
    }

    private void remove(String list, Instant listed) throws IOException {
        JsonNode all = read(list);
        for (JsonNode page : all.path("pages")) {
            if (!pages.contains(page.asText())) store.delete(new CatalogueRoot.Page("", 0, page.asText()).key());
        }
        for (JsonNode archive : all.path("archives"))
            removeArchive(archive.path(0).asText(), archive.path(1).asText(), listed);
        for (JsonNode model : all.path("models")) {
            String id = model.path(0).asText();
            if (!isBack(id, listed)) removeOlder(ModelKeys.pages(id), listed);
            removeArchive(id, model.path(1).asText(), listed);
        }
    }

    /** Whether a model that was taken off is in the catalogue again, or about to be. */
    private boolean isBack(String id, Instant listed) throws IOException {
        if (catalogue.find(id) != null) return true;
        StoredObject manifest = store.find(ModelKeys.manifest(id)).orElse(null);
        return manifest != null && isSince(manifest, listed);
    }

    /** Removes an archive unless the model has it now. */
    private void removeArchive(String id, String hash, Instant listed) throws IOException {
        if (hash.isEmpty()) return;
        String current = read(ModelKeys.manifest(id)).path("archiveSha256").asText();
        if (!current.equals(hash)) removeOlder(ModelKeys.archive(id, hash), listed);
    }

    private void removeOlder(List<String> keys, Instant listed) throws IOException {
        for (String key : keys) {
            StoredObject there = store.find(key).orElse(null);
            if (there != null && !isSince(there, listed)) store.delete(key);
        }
    }

    /** Clocks of stores may tell whole seconds. */
    private static boolean isSince(StoredObject object, Instant listed) {
        return !object.modified().isBefore(listed);
    }

    private JsonNode read(String key) throws IOException {
        try (InputStream in = store.open(key)) {
            return CatalogueJson.JSON.readTree(in);
        } catch (NoSuchFileException e) {
            return CatalogueJson.JSON.missingNode(); // Somebody else was quicker.
        }
    }
}
