package org.jsmesh.site;

import java.io.IOException;
import java.io.InputStream;
import java.util.List;
import org.jsmesh.objects.ObjectStore;

/**
 * Reads the catalogue of a site as it was at one time. Not thread-safe. It works for a day, as long as what is replaced
 * meanwhile stays.
 */
public final class CatalogueReader {
    private final ObjectStore store;
    private final CatalogueRoot root;
    private int pageRead = -1; // the one whose rows are kept
    private List<CatalogueRow> rows = List.of();

    /**
     * Opens a catalogue.
     *
     * @param store of the site
     * @throws IOException when it cannot be read
     */
    public CatalogueReader(ObjectStore store) throws IOException {
        this(store, CatalogueRoot.read(store));
    }

    CatalogueReader(ObjectStore store, CatalogueRoot root) {
        this.store = store;
        this.root = root;
    }

    /** {@return the number of models} */
    public long total() {
        return root.total();
    }

    /**
     * Looks for a model, by one request at most; by none when the one before was on the same page.
     *
     * @param id of the model
     * @return its row; null when it is not in the catalogue
     * @throws IOException when the catalogue cannot be read
     */
    public CatalogueRow find(String id) throws IOException {
        List<CatalogueRow> there = rows(page(id));
        int from = 0;
        int to = there.size();
        while (from < to) {
            int middle = (from + to) >>> 1;
            if (there.get(middle).id().compareTo(id) < 0) from = middle + 1;
            else to = middle;
        }
        return from < there.size() && there.get(from).id().equals(id) ? there.get(from) : null;
    }

    /** The last page whose first id is not greater; -1 for the root. */
    private int page(String id) {
        int from = -1;
        int to = root.pages().size() - 1;
        while (from < to) {
            int middle = (from + to + 1) >> 1;
            if (root.pages().get(middle).first().compareTo(id) <= 0) from = middle;
            else to = middle - 1;
        }
        return from;
    }

    private List<CatalogueRow> rows(int page) throws IOException {
        if (page < 0) return root.rows();
        if (page != pageRead) {
            String key = root.pages().get(page).key();
            try (InputStream in = store.open(key)) {
                rows = CatalogueJson.rows(in.readAllBytes(), store.address() + "/" + key);
            }
            pageRead = page;
        }
        return rows;
    }

    /** Takes rows. */
    @FunctionalInterface
    public interface Visitor {
        /**
         * Takes one.
         *
         * @param row the next in order of the ids
         * @throws IOException ends the reading
         */
        void visit(CatalogueRow row) throws IOException;
    }

    /**
     * Goes through all models, page by page.
     *
     * @param visitor is told of each
     * @throws IOException when the catalogue cannot be read, or from the visitor
     */
    public void forEach(Visitor visitor) throws IOException {
        for (int page = -1; page < root.pages().size(); page++) {
            for (CatalogueRow row : rows(page)) visitor.visit(row);
        }
    }
}
