package org.jsmesh.simulation;

import org.jsmesh.archive.BatchIndex;

/**
 * Decides what a client does with its time: how much it asks for, and whether it shows what is there when the wait is
 * over. Times are virtual milliseconds.
 */
interface SimulatedClient {
    void beginRound(double nowMillis, double waitMillis);

    /**
     * The next request of the round, when none is under way.
     *
     * @param index of the archive, or null before it has arrived
     * @return the byte to ask up to; −1 when the round asks for no more
     */
    long next(double nowMillis, BatchIndex index, long receivedBytes);

    void sent(double nowMillis);

    void arrived(double nowMillis, int bytes);

    /** The response is complete or was given up. */
    void ended(double nowMillis);

    /** Whether the round is over though a response is under way. */
    boolean isOver(double nowMillis, boolean basePresent);

    /** Whether, after the round, a response is read on. */
    boolean mayGoOn(double nowMillis, long bytesLeft);
}
