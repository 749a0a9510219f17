package org.jsmesh.site;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.Arrays;
import org.jsmesh.files.ArchiveParts;
import org.jsmesh.objects.Condition;
import org.jsmesh.objects.ObjectConflictException;
import org.jsmesh.objects.ObjectContent;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;
import org.jsmesh.objects.Upload;

/** Brings pages of models up to date with the site's own, while others may publish the same models. */
final class PageUpdate {
    private static final int MOST_TRIES = 20;

    private final ObjectStore store;
    private final ModelPublisher publisher;

    PageUpdate(ObjectStore store, ModelPublisher publisher) {
        this.store = store;
        this.publisher = publisher;
    }

    /** Writes the page of a model that has a manifest, after that. */
    void update(String id) throws IOException {
        for (int i = 1; !tryUpdate(id); i++) {
            if (i == MOST_TRIES)
                throw new ObjectConflictException(
                        store.address() + "/" + ModelKeys.page(id), "is written by others all the time. Try again");
        }
    }

    /** False when somebody else has written the page meanwhile. */
    private boolean tryUpdate(String id) throws IOException {
        String key = ModelKeys.page(id);
        // Before the manifest is read: who publishes writes the page last, so a newer manifest changes it once more.
        StoredObject there = store.find(key).orElse(null);
        byte[] content = ModelPublisher.read(store, ModelKeys.manifest(id));
        if (content == null) return true;
        JsonNode manifest = CatalogueJson.JSON.readTree(content);
        String hash = manifest.path("archiveSha256").asText();
        byte[] poster = manifest.has("posterUrl")
                ? ModelPublisher.read(store, ModelKeys.archive(id, hash, ArchiveParts.POSTER))
                : null;
        byte[] page = publisher.page(id, manifest.toString(), poster);
        if (there != null && there.bytes() == page.length && Arrays.equals(ModelPublisher.read(store, key), page))
            return true;
        try {
            store.put(Upload.of(key, ObjectContent.of(page))
                    .withHeaders(SiteHeaders.HTML, SiteHeaders.CHANGING)
                    .withCondition(Condition.replacing(there)));
            return true;
        } catch (ObjectConflictException e) {
            return false;
        }
    }
}
