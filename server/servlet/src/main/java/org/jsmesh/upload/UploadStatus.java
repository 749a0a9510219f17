package org.jsmesh.upload;

/**
 * The state of a model that was sent.
 *
 * @param id of the model
 * @param state of its encoding
 * @param stage what is being done, a few words
 * @param fraction of the stage, 0 to 1
 * @param error why there is no archive, or null
 * @param remedy what the sender can do about it, or null
 */
public record UploadStatus(String id, State state, String stage, double fraction, String error, String remedy) {
    /** State of its encoding. */
    public enum State {
        QUEUED,
        ENCODING,
        READY,
        FAILED
    }

    static UploadStatus queued(String id) {
        return new UploadStatus(id, State.QUEUED, "waiting", 0, null, null);
    }

    static UploadStatus encoding(String id, String stage, double fraction) {
        return new UploadStatus(id, State.ENCODING, stage, fraction, null, null);
    }

    static UploadStatus ready(String id) {
        return new UploadStatus(id, State.READY, "done", 1, null, null);
    }

    static UploadStatus failed(String id, String error, String remedy) {
        return new UploadStatus(id, State.FAILED, "failed", 0, error, remedy);
    }

    /** Whether the state will still change by itself. */
    public boolean isOver() {
        return state == State.READY || state == State.FAILED;
    }
}
