package org.jsmesh.upload;

import java.util.List;
import org.jsmesh.mesh.Note;

/**
 * The state of a model that was sent.
 *
 * @param id of the model
 * @param state of its encoding
 * @param stage what is being done, a few words
 * @param fraction of the stage, 0 to 1
 * @param error why there is no archive, or null
 * @param remedy what the sender can do about it, or null
 * @param notes what of the model is not in its archive; empty until that is ready
 */
public record UploadStatus(
        String id, State state, String stage, double fraction, String error, String remedy, List<Note> notes) {
    /** State of its encoding. */
    public enum State {
        /** It waits for its turn. */
        QUEUED,
        /** It is being encoded; stage and fraction say how far. */
        ENCODING,
        /** Its archive is in its place. */
        READY,
        /** There is no archive; error and remedy say why. */
        FAILED
    }

    /**
     * Copies the notes.
     *
     * @param id see {@link #id()}
     * @param state see {@link #state()}
     * @param stage see {@link #stage()}
     * @param fraction see {@link #fraction()}
     * @param error see {@link #error()}
     * @param remedy see {@link #remedy()}
     * @param notes see {@link #notes()}
     */
    public UploadStatus {
        notes = List.copyOf(notes);
    }

    static UploadStatus queued(String id) {
        return new UploadStatus(id, State.QUEUED, "waiting", 0, null, null, List.of());
    }

    static UploadStatus encoding(String id, String stage, double fraction) {
        return new UploadStatus(id, State.ENCODING, stage, fraction, null, null, List.of());
    }

    static UploadStatus ready(String id, List<Note> notes) {
        return new UploadStatus(id, State.READY, "done", 1, null, null, notes);
    }

    static UploadStatus failed(String id, String error, String remedy) {
        return new UploadStatus(id, State.FAILED, "failed", 0, error, remedy, List.of());
    }

    /** {@return true when the state no longer changes by itself: the model is ready or has failed} */
    public boolean isOver() {
        return state == State.READY || state == State.FAILED;
    }
}
