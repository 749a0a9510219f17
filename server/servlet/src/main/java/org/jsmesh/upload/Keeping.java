package org.jsmesh.upload;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.files.AtomicFiles;

/**
 * Remembers who sent which model, and says who may send more. The record is a file of lines {@code id key}, of which
 * the last for an id counts: a line is added for each model, and what no longer counts is left out at the next start.
 * Models whose archives are gone, whoever removed them, count no more. Thread-safe.
 */
final class Keeping {
    private static final Pattern LINE = Pattern.compile("([a-z0-9-]+) ([0-9a-f]{64})");

    /** Where the archive of a model is. */
    interface Place {
        Path of(String id);
    }

    private final Path file;
    private final Place place;
    private final Map<String, String> keys = new LinkedHashMap<>();

    /** Models on their way, by how many uploads there are of each. */
    private final Map<String, Integer> coming = new LinkedHashMap<>();

    private Keeping(Path file, Place place) {
        this.file = file;
        this.place = place;
    }

    static Keeping open(Path file, Place place) throws IOException {
        Keeping keeping = new Keeping(file, place);
        if (!Files.exists(file)) return keeping;
        for (String line : Files.readAllLines(file)) {
            Matcher words = LINE.matcher(line); // the last one may be cut
            if (words.matches()) keeping.keys.put(words.group(1), words.group(2));
        }
        keeping.keys.keySet().removeIf(id -> !Files.exists(place.of(id)));
        StringBuilder lines = new StringBuilder();
        keeping.keys.forEach(
                (id, key) -> lines.append(id).append(' ').append(key).append('\n'));
        AtomicFiles.write(file, lines.toString().getBytes(StandardCharsets.US_ASCII));
        return keeping;
    }

    /** Why the sender may not send a model, in words; null when they may, and then it counts until {@link #gone}. */
    synchronized String refusal(Sender sender, String id) {
        String reason = reason(sender, id, 0);
        if (reason == null) coming.merge(coming(sender.key(), id), 1, Integer::sum);
        return reason;
    }

    /** Counts a model that was accepted before the start. */
    synchronized void resume(String key, String id) {
        coming.merge(coming(key, id), 1, Integer::sum);
    }

    /** One upload is over, whatever came of it. */
    synchronized void gone(String key, String id) {
        coming.computeIfPresent(coming(key, id), (which, count) -> count == 1 ? null : count - 1);
    }

    private static String coming(String key, String id) {
        return id + ' ' + key;
    }

    /** Why the archive of a model may not be kept for the sender, in words; null when it may. */
    synchronized String refusal(Sender sender, String id, long bytes) {
        return reason(sender, id, bytes);
    }

    private String reason(Sender sender, String id, long more) {
        if (sender.mostBytes() == Long.MAX_VALUE && sender.mostModels() == Integer.MAX_VALUE) return null;
        long bytes = more;
        int models = 1;
        for (Map.Entry<String, String> kept : keys.entrySet()) {
            if (!kept.getValue().equals(sender.key()) || kept.getKey().equals(id)) continue;
            long size = size(kept.getKey());
            if (size < 0) continue;
            bytes += size;
            models++;
        }
        for (String one : coming.keySet()) {
            String other = one.substring(0, one.indexOf(' '));
            boolean counts = one.endsWith(' ' + sender.key()) && !other.equals(id) && !isKept(other, sender.key());
            if (counts) models++;
        }
        if (models > sender.mostModels())
            return "the server keeps " + sender.mostModels() + " models for this token, and not one more";
        boolean full = more > 0 ? bytes > sender.mostBytes() : bytes >= sender.mostBytes();
        if (!full) return null;
        return "the server keeps " + sender.mostBytes() + " bytes of archives for this token, "
                + (more > 0 ? "and with this one of " + more + " bytes they would be " + bytes : "and they are full");
    }

    private boolean isKept(String id, String key) {
        return key.equals(keys.get(id)) && size(id) >= 0;
    }

    /** Negative when there is none. */
    private long size(String id) {
        try {
            return Files.size(place.of(id));
        } catch (IOException e) {
            return -1;
        }
    }

    /** Notes whose model it is, before its archive is in its place. */
    synchronized void note(String key, String id) throws IOException {
        if (key.equals(keys.put(id, key))) return;
        // A line that was cut ends here.
        String line = "\n" + id + ' ' + key + '\n';
        try (FileChannel out = FileChannel.open(
                file, StandardOpenOption.CREATE, StandardOpenOption.WRITE, StandardOpenOption.APPEND)) {
            out.write(ByteBuffer.wrap(line.getBytes(StandardCharsets.US_ASCII)));
            out.force(true);
        }
    }

    /** The archive of a model is gone. */
    synchronized void forget(String id) {
        keys.remove(id);
    }
}
