package org.jsmesh.session;

import java.io.IOException;

/** An address could not be fetched. The message says what, where and what to do. */
public final class FetchException extends IOException {
    private static final long serialVersionUID = 1L;

    /** As the time to wait: the next attempt is another request, which has no reason to fail like the last one. */
    static final long AT_ONCE = -1;

    /** Whether the same request would fail again. */
    private final boolean last;

    /** Whether the address has what was asked for no more. */
    private final boolean gone;

    /** What the server asks to wait before the next attempt; 0 when it does not say. */
    private final long waitMillis;

    private FetchException(String message, Throwable cause, boolean last, boolean gone, long waitMillis) {
        super(message, cause);
        this.last = last;
        this.gone = gone;
        this.waitMillis = waitMillis;
    }

    /** Trying again may help. */
    static FetchException passing(String url, String what, String remedy) {
        return new FetchException(url + ": " + what + "; " + remedy, null, false, false, 0);
    }

    static FetchException passing(String url, String what, String remedy, Throwable cause) {
        return new FetchException(url + ": " + what + "; " + remedy, cause, false, false, 0);
    }

    /** Trying again may help, but only after so many milliseconds. */
    static FetchException passing(String url, String what, String remedy, long waitMillis) {
        return new FetchException(url + ": " + what + "; " + remedy, null, false, false, waitMillis);
    }

    /** Trying again gives the same answer. */
    static FetchException lasting(String url, String what, String remedy) {
        return new FetchException(url + ": " + what + "; " + remedy, null, true, false, 0);
    }

    /** The address no longer exists. */
    static FetchException gone(String url, String what, String remedy) {
        return new FetchException(url + ": " + what + "; " + remedy, null, true, true, 0);
    }

    /**
     * Time after which the server wants to be asked again, in milliseconds, or {@link #AT_ONCE}; 0 when it did not say.
     */
    long waitMillis() {
        return waitMillis;
    }

    /** True when the server said that the address does not exist. */
    boolean isGone() {
        return gone;
    }

    /** {@return true when the same request would fail again} */
    public boolean isLasting() {
        return last;
    }
}
