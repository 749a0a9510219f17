package org.jsmesh.session.testing;

import java.net.Socket;
import java.util.concurrent.locks.LockSupport;

/** What goes wrong on a link, when it is asked to. Thread-safe. */
final class LinkFaults {
    private long cutAfter = Long.MAX_VALUE;
    private long cutHeadAfter = Long.MAX_VALUE;
    private long corruptAt = -1;
    private volatile boolean stalling;
    private volatile String refused;

    synchronized void cutAfter(long bodyBytes) {
        cutAfter = bodyBytes;
    }

    synchronized void cutHeadAfter(long headBytes) {
        cutHeadAfter = headBytes;
    }

    synchronized void corrupt(long fileOffset) {
        corruptAt = fileOffset;
    }

    void stall() {
        stalling = true;
    }

    void endStalls() {
        stalling = false;
    }

    void refuse(String targetEnd) {
        refused = targetEnd;
    }

    /** Whether the connection breaks after so many bytes of a head; once. */
    synchronized boolean isHeadCut(int headBytes) {
        if (headBytes != cutHeadAfter) return false;
        cutHeadAfter = Long.MAX_VALUE;
        return true;
    }

    /** How many of these body bytes may pass before the connection breaks; counts them. */
    synchronized int pass(int bytes) {
        int pass = (int) Math.min(bytes, cutAfter);
        cutAfter = pass < bytes ? Long.MAX_VALUE : cutAfter == Long.MAX_VALUE ? cutAfter : cutAfter - pass;
        return pass;
    }

    /** Spoils the one byte of the file that is to be spoilt, if it is among these. */
    synchronized void spoil(byte[] buffer, int at, int bytes, long fileOffset) {
        long corrupt = corruptAt - fileOffset;
        if (corruptAt >= 0 && corrupt >= 0 && corrupt < bytes) buffer[at + (int) corrupt] ^= 1;
    }

    boolean isRefused(String target) {
        String end = refused;
        return end != null && target.endsWith(end);
    }

    /** Before a connection breaks: keeps it silent, when connections stall, until the client has closed it. */
    void keepSilent(Socket client) {
        while (stalling && !client.isClosed()) LockSupport.parkNanos(5_000_000);
    }
}
