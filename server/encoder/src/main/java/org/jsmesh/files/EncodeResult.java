package org.jsmesh.files;

import com.fasterxml.jackson.annotation.JsonIgnore;
import com.fasterxml.jackson.annotation.JsonPropertyOrder;
import com.fasterxml.jackson.databind.annotation.JsonSerialize;
import java.util.List;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.mesh.Note;

/**
 * The outcome for one model file; a row of the JSON array that {@code jsm encode --json} prints. All counts are 0 for a
 * file that failed.
 *
 * @param input the model file, as it was given
 * @param output the archive
 * @param faces of the original, likewise {@code vertices}
 * @param baseFaces faces of the base mesh
 * @param bytes of the archive
 * @param batches number of batches in the archive
 * @param encodeSeconds from reading to writing
 * @param notes what of the file is not in the archive as it was, in the order in which it was found
 * @param error why there is no archive, with place and remedy; null when there is one
 */
@JsonPropertyOrder({
    "input",
    "output",
    "faces",
    "vertices",
    "baseFaces",
    "bytes",
    "batches",
    "encodeSeconds",
    "notes",
    "error"
})
public record EncodeResult(
        String input,
        String output,
        int faces,
        int vertices,
        int baseFaces,
        long bytes,
        int batches,
        double encodeSeconds,
        @JsonSerialize(contentUsing = NoteJson.class) List<Note> notes,
        String error) {

    /**
     * Copies the notes.
     *
     * @param input see {@link #input()}
     * @param output see {@link #output()}
     * @param faces see {@link #faces()}
     * @param vertices see {@link #vertices()}
     * @param baseFaces see {@link #baseFaces()}
     * @param bytes see {@link #bytes()}
     * @param batches see {@link #batches()}
     * @param encodeSeconds see {@link #encodeSeconds()}
     * @param notes see {@link #notes()}
     * @param error see {@link #error()}
     */
    public EncodeResult {
        notes = List.copyOf(notes);
    }

    /**
     * The result for a file that became an archive.
     *
     * @param job the file and the place of its archive
     * @param header of the archive; the counts are taken from it
     * @param seconds from reading to writing
     * @param notes what of the file is not in the archive as it was
     * @return a result without an error
     */
    public static EncodeResult of(EncodeJob job, ArchiveHeader header, double seconds, List<Note> notes) {
        BatchIndex batches = header.batches();
        return new EncodeResult(
                job.input().toString(),
                job.output().toString(),
                header.faces(),
                header.vertices(),
                batches.faces(0),
                batches.archiveBytes(),
                batches.size(),
                seconds,
                notes,
                null);
    }

    /**
     * The result for a file that did not become an archive.
     *
     * @param job the file and the place that an archive would have
     * @param seconds until it failed
     * @param error why, with place and remedy
     * @return a result without an archive
     */
    public static EncodeResult failed(EncodeJob job, double seconds, String error) {
        return new EncodeResult(
                job.input().toString(), job.output().toString(), 0, 0, 0, 0, 0, seconds, List.of(), error);
    }

    /**
     * Moves the archive.
     *
     * @param place where it is now
     * @return a result that differs in that alone
     */
    public EncodeResult withOutput(String place) {
        return new EncodeResult(input, place, faces, vertices, baseFaces, bytes, batches, encodeSeconds, notes, error);
    }

    /**
     * Tells of the same file that its archive could not be put in its place.
     *
     * @param reason with place and remedy
     * @return a result without an archive
     */
    public EncodeResult failed(String reason) {
        return new EncodeResult(input, output, 0, 0, 0, 0, 0, encodeSeconds, List.of(), reason);
    }

    /** {@return true when there is no archive} */
    @JsonIgnore
    public boolean isFailed() {
        return error != null;
    }
}
