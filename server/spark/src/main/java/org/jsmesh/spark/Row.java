package org.jsmesh.spark;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.Serializable;
import java.time.Instant;

/**
 * What a run knows of a model: a row of the report, by which the next run finds what has changed. Either facts or a
 * failure is there; with a failure the entry is that of the archive which the site had before, if any.
 *
 * @param id in the catalogue
 * @param file that was read
 * @param stamp of the run
 * @param companions that were asked for, see {@link CompanionTag#toJson}
 * @param annotations tag of what people wrote beside the file; empty for none
 * @param facts of the archive, or null
 * @param failure why there is no archive of this file, or null
 * @param notes what of the file is not in the archive as it was, one a line
 * @param entry of the catalogue as JSON; empty when the site does not have the model
 * @param entryRun name of the run that published what the entry tells of; empty without an entry
 */
record Row(
        String id,
        ListedModel file,
        Stamp stamp,
        String companions,
        String annotations,
        Facts facts,
        Failure failure,
        String notes,
        String entry,
        String entryRun)
        implements Serializable {
    private static final long serialVersionUID = 1;
    private static final ObjectMapper JSON = new ObjectMapper();

    /** With an entry of the run itself, if any. */
    Row(
            String id,
            ListedModel file,
            Stamp stamp,
            String companions,
            String annotations,
            Facts facts,
            Failure failure,
            String notes,
            String entry) {
        this(
                id,
                file,
                stamp,
                companions,
                annotations,
                facts,
                failure,
                notes,
                entry,
                entry.isEmpty() ? "" : stamp.run());
    }

    /**
     * What of a run decides the bytes.
     *
     * @param run its name
     * @param settings see {@link CatalogueSettings#key}
     * @param encoderVersion of the encoder
     */
    record Stamp(String run, String settings, int encoderVersion) implements Serializable {
        private static final long serialVersionUID = 1;

        boolean makesTheSameAs(Stamp other) {
            return settings.equals(other.settings) && encoderVersion == other.encoderVersion;
        }
    }

    /**
     * Of an archive.
     *
     * @param output its address
     * @param sha256 of its bytes
     * @param faces of the original
     * @param vertices of the original
     * @param baseFaces faces of the base mesh
     * @param bytes of the archive
     * @param batches number of batches
     * @param encodeSeconds from reading to writing
     */
    record Facts(
            String output,
            String sha256,
            int faces,
            int vertices,
            int baseFaces,
            long bytes,
            int batches,
            double encodeSeconds)
            implements Serializable {
        private static final long serialVersionUID = 1;
    }

    /**
     * Why a model was not encoded.
     *
     * @param place file with line or byte
     * @param reason what is wrong
     * @param remedy what to do
     * @param kind what the next run does about it
     */
    record Failure(String place, String reason, String remedy, Kind kind) implements Serializable {
        private static final long serialVersionUID = 1;

        /** {@return whether the same file may do better another time} */
        boolean isWorthAnotherTry() {
            return kind != Kind.MODEL;
        }
    }

    /** Where the fault is. */
    enum Kind {
        /** In the model: it fails the same way each time. */
        MODEL,
        /** The executors have too little memory. */
        MEMORY,
        /** Somewhere between: a store, the network, a file that changed. */
        ROAD
    }

    boolean isFailed() {
        return failure != null;
    }

    /** {@return what is known of a model after a further row of it: one that fails stays in the site as it was} */
    Row then(Row next) {
        return next.isFailed() && next.entry.isEmpty() ? next.withEntry(entry, entryRun) : next;
    }

    private Row withEntry(String other, String run) {
        return new Row(id, file, stamp, companions, annotations, facts, failure, notes, other, run);
    }

    /** {@return the row with the members that {@link RowParquet} has as columns} */
    ObjectNode toJson() {
        ObjectNode n = JSON.createObjectNode();
        n.put("id", id).put("state", isFailed() ? "failed" : "encoded").put("input", file.input());
        n.put("store", file.store()).put("key", file.key()).put("place", file.place());
        n.put("inputBytes", file.bytes()).put("inputTag", file.tag());
        n.put("run", stamp.run).put("settings", stamp.settings).put("encoderVersion", stamp.encoderVersion);
        if (facts != null) {
            n.put("output", facts.output).put("archiveSha256", facts.sha256);
            n.put("faces", facts.faces).put("vertices", facts.vertices).put("baseFaces", facts.baseFaces);
            n.put("bytes", facts.bytes).put("batches", facts.batches).put("encodeSeconds", facts.encodeSeconds);
        }
        if (failure != null) {
            n.put("errorPlace", failure.place).put("errorReason", failure.reason);
            n.put("errorRemedy", failure.remedy).put("errorKind", failure.kind.name());
        }
        n.put("notes", notes).put("companions", companions).put("annotations", annotations);
        return n.put("entry", entry).put("entryRun", entryRun);
    }

    static Row fromJson(JsonNode n) {
        String error = n.path("errorReason").textValue();
        Facts facts = !n.hasNonNull("output")
                ? null
                : new Facts(
                        text(n, "output"),
                        text(n, "archiveSha256"),
                        n.path("faces").asInt(),
                        n.path("vertices").asInt(),
                        n.path("baseFaces").asInt(),
                        n.path("bytes").asLong(),
                        n.path("batches").asInt(),
                        n.path("encodeSeconds").asDouble());
        Failure failure = error == null
                ? null
                : new Failure(text(n, "errorPlace"), error, text(n, "errorRemedy"), Kind.valueOf(text(n, "errorKind")));
        return new Row(
                text(n, "id"),
                new ListedModel(
                        text(n, "store"),
                        text(n, "key"),
                        text(n, "place"),
                        n.path("inputBytes").asLong(),
                        text(n, "inputTag"),
                        Instant.EPOCH),
                new Stamp(
                        text(n, "run"),
                        text(n, "settings"),
                        n.path("encoderVersion").asInt()),
                text(n, "companions"),
                text(n, "annotations"),
                facts,
                failure,
                text(n, "notes"),
                text(n, "entry"),
                text(n, "entryRun"));
    }

    static Row fromJson(String line) {
        try {
            return fromJson(JSON.readTree(line));
        } catch (JsonProcessingException e) {
            throw new IllegalArgumentException("no row of a report: " + line, e);
        }
    }

    private static String text(JsonNode n, String name) {
        return n.path(name).asText("");
    }
}
