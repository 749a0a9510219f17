package org.jsmesh.spark;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.jsmesh.objects.Condition;
import org.jsmesh.objects.ObjectContent;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;
import org.jsmesh.objects.Upload;

/**
 * The report of a site in its store, which the next run begins with:
 *
 * <pre>
 *     summary.json                     counts, settings and the names of the parts; written last
 *     models-{run}-{number}.parquet    rows in the order of ids
 *     models-{run}-{number}.json       the same rows, an object a line
 *     journal/{run}/{bin}-{attempt}-{number}.json    rows of a run that has not ended
 * </pre>
 *
 * A run that is broken off leaves its journal, so that the next one knows what it had done.
 */
final class Ledger {
    static final String SUMMARY = "summary.json";
    private static final String PARTS = "models-";
    private static final String JOURNAL = "journal/";
    private static final ObjectMapper JSON = new ObjectMapper();

    private final ObjectStore store;

    Ledger(ObjectStore store) {
        this.store = store;
    }

    /** What {@link #SUMMARY} says, and its version. */
    record Summary(StoredObject object, JsonNode content) {
        /** {@return names of the Parquet files of the report, in the order of their rows} */
        List<String> parts() {
            List<String> names = new ArrayList<>();
            content.path("parts").forEach(part -> names.add(part.asText()));
            return names;
        }

        /** {@return how many rows these have, about} */
        long rows() {
            return content.path("published").asLong() + content.path("failed").asLong();
        }
    }

    Optional<Summary> summary() throws IOException {
        Optional<StoredObject> found = store.find(SUMMARY);
        if (found.isEmpty()) return Optional.empty();
        try {
            return Optional.of(new Summary(found.get(), JSON.readTree(bytes(SUMMARY))));
        } catch (JsonProcessingException e) {
            throw new IOException(
                    store.address() + "/" + SUMMARY + ": is no JSON. Remove it; all models are encoded again then", e);
        }
    }

    /**
     * What a run begins with.
     *
     * @param summary of the last run, or null
     * @param keys of all parts and of all that is below the journal
     */
    record Start(Summary summary, List<String> keys) {
        /** {@return names of all files with rows, later ones behind earlier ones} */
        List<String> parts() {
            List<String> names = new ArrayList<>();
            if (summary != null) names.addAll(summary.parts());
            names.addAll(journals());
            return names;
        }

        /** Those that runs have left which were broken off, or that still go on. */
        private List<String> journals() {
            return keys.stream()
                    .filter(key -> key.startsWith(JOURNAL) && key.endsWith(".json"))
                    .toList();
        }

        /** {@return names of the runs with journals: what they published may be in no catalogue yet} */
        Set<String> openRuns() {
            return journals().stream().map(name -> name.split("/")[1]).collect(Collectors.toSet());
        }

        /** {@return how many rows there are, about} */
        long rows() {
            return journals().size() + (summary == null ? 0 : summary.rows());
        }
    }

    Start start() throws IOException {
        Summary summary = summary().orElse(null);
        List<String> keys = new ArrayList<>();
        store.list(PARTS, "", object -> keys.add(object.key()));
        store.list(JOURNAL, "", object -> keys.add(object.key()));
        return new Start(summary, keys);
    }

    /** {@return whether another run has ended since} */
    boolean hasChangedSince(Start start) throws IOException {
        StoredObject before = start.summary() == null ? null : start.summary().object();
        return !Objects.equals(before, store.find(SUMMARY).orElse(null));
    }

    /** {@return names of the journals that begin so, in the order of their names} */
    List<String> journalsOf(String begin) throws IOException {
        List<String> names = new ArrayList<>();
        store.list(begin, "", object -> !object.key().endsWith(".json") || names.add(object.key()));
        return names;
    }

    void read(String part, Consumer<Row> rows) throws IOException {
        if (!part.startsWith(JOURNAL)) {
            RowParquet.read(bytes(part), rows);
            return;
        }
        for (String line : new String(bytes(part), StandardCharsets.UTF_8).split("\n"))
            if (!line.isEmpty()) rows.accept(Row.fromJson(line));
    }

    private byte[] bytes(String key) throws IOException {
        try (InputStream in = store.open(key)) {
            return in.readAllBytes();
        }
    }

    /** Writes a part of the report. */
    String writePart(String run, int number, List<Row> rows) throws IOException {
        String name = String.format("%s%s-%05d", PARTS, run, number);
        put(name + ".json", "application/x-ndjson", lines(rows));
        put(name + ".parquet", "application/vnd.apache.parquet", RowParquet.write(rows.iterator()));
        return name + ".parquet";
    }

    /** What the names of a bin's journals begin with, of which every attempt has its own. */
    static String bin(String run, int bin) {
        return String.format("%s%s/bin-%06d-", JOURNAL, run, bin);
    }

    /** What the names of an attempt's journals begin with, see {@link Journal}. */
    static String attempt(String run, int bin, long attempt) {
        return bin(run, bin) + attempt + "-";
    }

    static String refused(String run, int number, long attempt) {
        return String.format("%s%s/refused-%06d-%d.json", JOURNAL, run, number, attempt);
    }

    void writeJournal(String name, List<Row> rows) throws IOException {
        put(name, "application/x-ndjson", lines(rows));
    }

    private static byte[] lines(List<Row> rows) {
        return rows.stream()
                .map(row -> row.toJson() + "\n")
                .collect(Collectors.joining())
                .getBytes(StandardCharsets.UTF_8);
    }

    void put(String key, String type, byte[] content) throws IOException {
        store.put(Upload.of(key, ObjectContent.of(content)).withHeaders(type, null));
    }

    void delete(String key) throws IOException {
        store.delete(key);
    }

    Optional<String> note(String key) throws IOException {
        return store.find(key).isEmpty()
                ? Optional.empty()
                : Optional.of(new String(bytes(key), StandardCharsets.UTF_8));
    }

    /**
     * Ends a run: names its parts, then removes what they replace, and the run's journals. What others have written
     * since it began stays.
     *
     * @param before what the run began with
     * @param run its name
     * @throws org.jsmesh.objects.ObjectConflictException when another run has ended meanwhile
     */
    void commit(ObjectNode summary, List<String> parts, Start before, String run) throws IOException {
        ArrayNode names = summary.putArray("parts");
        parts.forEach(names::add);
        byte[] content = (summary.toPrettyString() + "\n").getBytes(StandardCharsets.UTF_8);
        store.put(Upload.of(SUMMARY, ObjectContent.of(content))
                .withHeaders("application/json", "no-cache")
                .withCondition(Condition.replacing(
                        before.summary() == null ? null : before.summary().object())));
        List<String> old = new ArrayList<>(before.keys());
        store.list(JOURNAL + run + "/", "", object -> old.add(object.key()));
        for (String key : old) store.delete(key);
    }
}
