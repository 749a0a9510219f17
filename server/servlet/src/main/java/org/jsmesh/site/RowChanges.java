package org.jsmesh.site;

import java.io.IOException;
import java.util.Iterator;
import java.util.List;

/** Changes in order, merged with rows that are there. */
final class RowChanges {
    private final Iterator<CatalogueRow> changes;
    private final Counter counter;
    private CatalogueRow next;

    /** Is told of changes. */
    interface Counter {
        /** @param old null when there was none */
        void count(CatalogueRow old, CatalogueRow row) throws IOException;
    }

    /** Takes rows. */
    interface Sink {
        void add(CatalogueRow row) throws IOException;
    }

    RowChanges(Iterator<CatalogueRow> changes, Counter counter) {
        this.changes = changes;
        this.counter = counter;
        next = changes.hasNext() ? changes.next() : null;
    }

    /** Whether there are changes of ids before this one; null for any. */
    boolean isBefore(String end) {
        return next != null && (end == null || next.id().compareTo(end) < 0);
    }

    private void advance() {
        CatalogueRow last = next;
        next = changes.hasNext() ? changes.next() : null;
        if (next != null && next.id().compareTo(last.id()) <= 0)
            throw new IllegalArgumentException(
                    "the change of " + next.id() + " comes behind that of " + last.id() + ": sort them by ids");
    }

    /**
     * Gives on the rows that are there, changed, and those that come between them.
     *
     * @param end id behind the last one that could be among them; null for none
     */
    void merge(List<CatalogueRow> there, String end, Sink sink) throws IOException {
        for (CatalogueRow row : there) {
            while (isBefore(row.id())) insert(sink);
            if (next == null || !next.id().equals(row.id())) {
                sink.add(row);
                continue;
            }
            replace(row, sink);
            advance();
        }
        while (isBefore(end)) insert(sink);
    }

    private void insert(Sink sink) throws IOException {
        if (!next.isRemoval()) {
            counter.count(null, next);
            sink.add(next);
        }
        advance();
    }

    private void replace(CatalogueRow row, Sink sink) throws IOException {
        if (next.isRemoval()) {
            counter.count(row, next);
            return;
        }
        String merged = CatalogueJson.merge(row.json(), next.json());
        if (merged.equals(row.json())) {
            sink.add(row);
            return;
        }
        CatalogueRow changed = new CatalogueRow(row.id(), merged);
        counter.count(row, changed);
        sink.add(changed);
    }
}
