package org.jsmesh.spark;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.Iterator;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.Set;
import java.util.TreeSet;
import org.jsmesh.site.CatalogueRow;

/**
 * What a run changes in the catalogue, in the order of ids, read from its report part by part. Of models that it did
 * not encode others may have written to the catalogue since: these stay as they are.
 */
final class CatalogueChanges implements Iterable<CatalogueRow> {
    private final Ledger ledger;
    private final List<String> parts;
    private final List<String> gone;
    private final Set<String> runs;

    /**
     * @param parts of the report, in the order of ids
     * @param gone ids of models that the catalogue is to forget
     * @param runs whose archives are not in the catalogue yet
     */
    CatalogueChanges(Ledger ledger, List<String> parts, Collection<String> gone, Set<String> runs) {
        this.ledger = ledger;
        this.parts = parts;
        this.gone = List.copyOf(new TreeSet<>(gone));
        this.runs = Set.copyOf(runs);
    }

    @Override
    public Iterator<CatalogueRow> iterator() {
        Iterator<String> rest = parts.iterator();
        Deque<CatalogueRow> rows = new ArrayDeque<>();
        Deque<String> removals = new ArrayDeque<>(gone);
        return new Iterator<>() {
            @Override
            public boolean hasNext() {
                while (rows.isEmpty() && rest.hasNext()) fill(rest.next(), rows);
                return !rows.isEmpty() || !removals.isEmpty();
            }

            @Override
            public CatalogueRow next() {
                if (!hasNext()) throw new NoSuchElementException();
                boolean isRemoval = !removals.isEmpty()
                        && (rows.isEmpty()
                                || removals.peek().compareTo(rows.peek().id()) < 0);
                return isRemoval ? CatalogueRow.removal(removals.poll()) : rows.poll();
            }
        };
    }

    private void fill(String part, Deque<CatalogueRow> rows) {
        try {
            ledger.read(part, row -> {
                if (runs.contains(row.entryRun())) rows.add(new CatalogueRow(row.id(), row.entry()));
            });
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
