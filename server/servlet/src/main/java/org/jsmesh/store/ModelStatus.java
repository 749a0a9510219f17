package org.jsmesh.store;

/**
 * The state of a model, for a catalogue.
 *
 * @param entry the model
 * @param state whether it can be served
 * @param facts of its archive when it is {@link State#READY}, otherwise null
 * @param stage what is being done when it is {@link State#PREPARING}, otherwise null
 * @param fraction of the stage, 0 to 1
 * @param failure why it is {@link State#FAILED}, otherwise null
 */
public record ModelStatus(
        ModelEntry entry,
        State state,
        ArchiveFacts facts,
        String stage,
        double fraction,
        ModelUnavailableException failure) {

    /** Whether a model can be served. */
    public enum State {
        /** Nobody has asked for it; a model file is encoded when its manifest is asked for. */
        NEW,
        /** It waits, is encoded or is read. */
        PREPARING,
        /** Its archive can be sent. */
        READY,
        /** It cannot be served. */
        FAILED
    }
}
