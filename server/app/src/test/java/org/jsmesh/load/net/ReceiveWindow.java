package org.jsmesh.load.net;

/** What the other end may still send of one stream or of the connection; topped up when half of it is used. */
final class ReceiveWindow {
    private final int size;
    private int left;

    ReceiveWindow(int size) {
        this.size = size;
        left = size;
    }

    /** Takes note of bytes that came; false when these are more than were granted. */
    boolean take(int bytes) {
        left -= bytes;
        return left >= 0;
    }

    /** How much to grant now; 0 for nothing yet. */
    int grant() {
        if (left > size / 2) return 0;
        int granted = size - left;
        left = size;
        return granted;
    }
}
