package org.jsmesh.codec.connectivity;

/** How far one thread has come, for another one that follows; what the first has written by then, the second sees. */
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

    /** Nothing follows, be it because of a failure. */
    void end() {
        isOver = true;
    }

    /** Waits until more than {@code index} is reached. False when that will not be. */
    boolean await(int index, PairRunner helper) {
        while (reached <= index) {
            if (isOver) return reached > index;
            helper.pause();
        }
        return true;
    }
}
