package org.jsmesh.spark;

import java.io.IOException;
import java.nio.charset.StandardCharsets;

/**
 * How often a process ended at a model, noted beside the journals of its bin before each model. A task that is stopped,
 * or lacks a class, takes its note away: another model would fare no better.
 *
 * @param count attempts that began with the model and were heard of no more
 */
record Losses(int count) {
    /**
     * Notes that a model is begun.
     *
     * @param bin see {@link Ledger#bin}
     */
    static Losses begin(Ledger ledger, String bin, String id) throws IOException {
        String[] note = ledger.note(key(bin)).orElse("0 ").split(" ", 2);
        int before = note[1].equals(id) ? Integer.parseInt(note[0]) : 0;
        byte[] next = ((before + 1) + " " + id).getBytes(StandardCharsets.UTF_8);
        ledger.put(key(bin), "text/plain; charset=utf-8", next);
        return new Losses(before);
    }

    /** Notes that whatever has ended, the process has not. */
    static void end(Ledger ledger, String bin) throws IOException {
        ledger.delete(key(bin));
    }

    private static String key(String bin) {
        return bin + "begun";
    }
}
