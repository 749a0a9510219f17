package org.jsmesh.desktop;

import org.jsmesh.session.SessionProgress;

/**
 * The state of a session as the window shows it. Immutable.
 *
 * @param phase what is going on
 * @param progress the figures, or null before the first bytes
 * @param levels of the model, 0 before its header
 * @param message an error in words, or a remark, or null
 * @param prepared how far a model is that is encoded first, 0 to 1; negative when none is
 */
record ViewState(Phase phase, SessionProgress progress, int levels, String message, double prepared) {
    /**
     * The phase of a session: {@code EMPTY} has no model; {@code PREPARING} waits for one that is encoded, here or by
     * the server; {@code RETRYING} waits for the next attempt after a broken connection; {@code CHECKING} computes the
     * hashes when everything has arrived; {@code IDENTICAL}, {@code INCOMPLETE} (all of the archive, which lacks of its
     * file something that is seen) and {@code DIFFERENT} are the outcomes.
     */
    enum Phase {
        EMPTY,
        PREPARING,
        LOADING,
        REFINING,
        RETRYING,
        CHECKING,
        IDLE,
        IDENTICAL,
        INCOMPLETE,
        DIFFERENT,
        ERROR
    }

    static final ViewState EMPTY = new ViewState(Phase.EMPTY, null, 0, null);
    static final ViewState START = new ViewState(Phase.LOADING, null, 0, null);

    ViewState(Phase phase, SessionProgress progress, int levels, String message) {
        this(phase, progress, levels, message, -1);
    }

    ViewState with(Phase next) {
        return new ViewState(next, progress, levels, message);
    }

    ViewState with(SessionProgress next) {
        return new ViewState(phase, next, levels, message);
    }

    ViewState withLevels(int count) {
        return new ViewState(phase, progress, count, message);
    }

    ViewState withMessage(String text) {
        return new ViewState(phase, progress, levels, text, prepared);
    }

    /** The model is encoded; it is that far. */
    ViewState preparing(String words, double fraction) {
        return new ViewState(Phase.PREPARING, progress, levels, words, Math.max(0, Math.min(1, fraction)));
    }

    /** True when everything has come. */
    boolean isOver() {
        return phase == Phase.IDENTICAL || phase == Phase.INCOMPLETE || phase == Phase.DIFFERENT;
    }

    /** True when another round can be asked for. */
    boolean canRefine() {
        return phase == Phase.IDLE || phase == Phase.ERROR;
    }

    /** True when something is going on that can be stopped. */
    boolean isBusy() {
        return switch (phase) {
            case PREPARING, LOADING, REFINING, RETRYING -> true;
            default -> false;
        };
    }
}
