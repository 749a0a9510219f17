package org.jsmesh.site;

import java.io.IOException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;

/**
 * Removes the objects of models that an update has just taken off the catalogue of a bucket. A model stays of which
 * somebody has written an object since, as whoever publishes it does, unless all was there and less than half a day
 * old: the catalogue would then name a model without objects until it is published once more. Not thread-safe.
 */
public final class RemovedModels {
    private final ObjectStore store;
    private final CatalogueReader catalogue;
    private final Instant since; // by the store's clock

    /**
     * Reads the catalogue.
     *
     * @param store of the site
     * @param since when the models were taken off, see {@link CatalogueWriter#time}
     * @throws IOException when the catalogue cannot be read
     */
    public RemovedModels(ObjectStore store, Instant since) throws IOException {
        this.store = store;
        this.since = since;
        catalogue = new CatalogueReader(store);
    }

    /**
     * Removes a model, its page and manifest first.
     *
     * @param id of the model
     * @return whether it went; else the catalogue names it again, or is about to
     * @throws IOException when the site cannot be read or written
     */
    public boolean remove(String id) throws IOException {
        if (catalogue.find(id) != null) return false;
        List<StoredObject> found = new ArrayList<>();
        store.list("m/" + id + "/", "", found::add);
        for (StoredObject object : found) if (!object.modified().isBefore(since)) return false;
        List<String> pages = ModelKeys.pages(id);
        found.sort(Comparator.comparing(object -> !pages.contains(object.key())));
        for (StoredObject object : found) store.delete(object.key());
        return true;
    }
}
