package org.jsmesh.spark;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * Rows of an attempt at a bin, each once. What is written after every row is a journal of some dozen rows, not all rows
 * again: a bin may have thousands.
 */
final class Journal {
    /** Rows after which a further journal begins. */
    static final int MANY = 32;

    private final Ledger ledger;
    private final String begin;
    private final List<String> whole = new ArrayList<>();
    private final List<Row> rows = new ArrayList<>(); // of the one that is not whole yet

    /** @param begin what the names of this attempt's journals begin with, see {@link Ledger#attempt} */
    Journal(Ledger ledger, String begin) {
        this.ledger = ledger;
        this.begin = begin;
    }

    void add(Row row) {
        rows.add(row);
    }

    /** Writes what has been added so far. */
    void write() throws IOException {
        write(rows.size() >= MANY);
    }

    /**
     * Writes the rest.
     *
     * @return names of all journals
     */
    List<String> end() throws IOException {
        write(true);
        return List.copyOf(whole);
    }

    private void write(boolean isWhole) throws IOException {
        if (rows.isEmpty()) return;
        String name = begin + whole.size() + ".json";
        ledger.writeJournal(name, rows);
        if (!isWhole) return;
        whole.add(name);
        rows.clear();
    }
}
