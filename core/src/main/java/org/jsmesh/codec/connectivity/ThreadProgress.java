package org.jsmesh.codec.connectivity;

/**
 * Tells a thread how far another one has come that it follows. The second thread then sees what the first has written.
 */
final class ThreadProgress {
    private volatile int reached;
    private volatile boolean isOver;

    void begin() {
        reached = 0;
        isOver = false;
    }

    void reach(int count) {
        reached = count;
    }

    /** Says that nothing more follows, also after a failure. */
    void end() {
        isOver = true;
    }

    /** Waits until more than {@code index} is reached. Returns false when that will not happen. */
    boolean await(int index, PairRunner helper) {
        while (reached <= index) {
            if (isOver) return reached > index;
            helper.pause();
        }
        return true;
    }
}
