package org.jsmesh.spark;

import java.io.IOException;
import java.nio.charset.StandardCharsets;

/**
 * How often a task was broken off at a model, noted beside its journal before each model.
 *
 * @param count attempts that began with the model and did not come to the next
 */
record Losses(int count) {
    static final Losses NONE = new Losses(0);

    /** Notes that a model is begun. */
    static Losses begin(Ledger ledger, String journal, String id) throws IOException {
        String key = journal.replaceFirst("json$", "begun");
        String[] note = ledger.note(key).orElse("0 ").split(" ", 2);
        int before = note[1].equals(id) ? Integer.parseInt(note[0]) : 0;
        byte[] next = ((before + 1) + " " + id).getBytes(StandardCharsets.UTF_8);
        ledger.put(key, "text/plain; charset=utf-8", next);
        return new Losses(before);
    }
}
