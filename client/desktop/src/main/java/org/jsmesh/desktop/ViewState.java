package org.jsmesh.desktop;

import org.jsmesh.session.SessionProgress;

/**
 * The state of a session as the window shows it. Immutable.
 *
 * @param phase what is going on
 * @param progress the figures, or null before the first bytes
 * @param levels of the model, 0 before its header
 * @param message an error in words, or a remark, or null
 */
record ViewState(Phase phase, SessionProgress progress, int levels, String message) {
    /**
     * The phase of a session: {@code CHECKING} computes the hashes when everything has arrived; {@code IDENTICAL},
     * {@code INCOMPLETE} (all of the archive, which lacks of its file something that is seen) and {@code DIFFERENT} are
     * the outcomes.
     */
    enum Phase {
        LOADING,
        REFINING,
        CHECKING,
        IDLE,
        IDENTICAL,
        INCOMPLETE,
        DIFFERENT,
        ERROR
    }

    static final ViewState START = new ViewState(Phase.LOADING, null, 0, null);

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
        return new ViewState(phase, progress, levels, text);
    }

    /** True when everything has come. */
    boolean isOver() {
        return phase == Phase.IDENTICAL || phase == Phase.INCOMPLETE || phase == Phase.DIFFERENT;
    }

    /** True when another round can be asked for. */
    boolean canRefine() {
        return phase == Phase.IDLE || phase == Phase.ERROR;
    }
}
