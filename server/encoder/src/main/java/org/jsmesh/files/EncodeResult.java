package org.jsmesh.files;

import com.fasterxml.jackson.annotation.JsonIgnore;
import com.fasterxml.jackson.annotation.JsonPropertyOrder;
import java.util.List;

/**
 * What became of one model file; a row of the JSON array that {@code jsm encode --json} prints. Of a file that failed
 * all counts are 0.
 *
 * @param input the model file, as it was given
 * @param output the archive
 * @param faces of the original, likewise {@code vertices}
 * @param baseFaces faces of the base mesh
 * @param bytes of the archive
 * @param batches number of batches in the archive
 * @param encodeSeconds from reading to writing
 * @param repaired what was changed to make a mesh of it, one sentence each
 * @param dropped what of the file is not in the archive, one sentence each
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
    "repaired",
    "dropped",
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
        List<String> repaired,
        List<String> dropped,
        String error) {

    static EncodeResult failed(EncodeJob job, double seconds, String error) {
        return new EncodeResult(
                job.input().toString(), job.output().toString(), 0, 0, 0, 0, 0, seconds, List.of(), List.of(), error);
    }

    /** The same with its archive in another place. */
    public EncodeResult withOutput(String place) {
        return new EncodeResult(
                input, place, faces, vertices, baseFaces, bytes, batches, encodeSeconds, repaired, dropped, error);
    }

    /** The same file, whose archive could not be put in its place. */
    public EncodeResult failed(String reason) {
        return new EncodeResult(input, output, 0, 0, 0, 0, 0, encodeSeconds, List.of(), List.of(), reason);
    }

    @JsonIgnore
    public boolean isFailed() {
        return error != null;
    }
}
