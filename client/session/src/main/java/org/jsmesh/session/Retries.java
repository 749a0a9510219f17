package org.jsmesh.session;

import java.io.IOException;
import java.net.UnknownHostException;
import java.nio.channels.UnresolvedAddressException;
import java.util.function.BooleanSupplier;
import org.jsmesh.mesh.MalformedStreamException;

/** Failures in a row: which of them end a call, and how long to wait before it goes on after the others. */
final class Retries {
    /** Hears of a pause before it begins. */
    interface Pausing {
        /**
         * @param error what failed
         * @param attempt that follows, from 2 on
         * @param millis until then; −1 when the round ends before
         */
        void heard(IOException error, int attempt, long millis);
    }

    private final ArchiveSource source;
    private final ReceivedArchive archive;
    private final SessionOptions options;
    private final SteadyClock clock;
    private final Pausing pausing;
    private final Impatience impatience = new Impatience();
    private int failures;
    private long askedToWaitMillis;
    private IOException last;

    Retries(ArchiveSource source, ReceivedArchive archive, SessionOptions options, SteadyClock clock, Pausing pausing) {
        this.pausing = pausing;
        this.source = source;
        this.archive = archive;
        this.options = options;
        this.clock = clock;
    }

    /** Something has arrived, or a call begins: what failed before is forgotten. */
    void reset() {
        failures = 0;
    }

    /**
     * Counts a failure.
     *
     * @throws IOException when it ends the call
     */
    void failed(IOException error) throws IOException {
        if (error instanceof MalformedStreamException || error instanceof ArchiveChangedException) throw error;
        if (error instanceof FetchException fetch && fetch.isLasting()) throw error;
        // A name that is unknown at the start is a wrong one or there is no network; later it may be looked up again.
        if (archive.bytes() == 0 && isUnknownHost(error)) {
            String what = "the host is unknown or the network is down";
            throw FetchException.passing(source.name(), what, "check the address and the network", error);
        }
        askedToWaitMillis = error instanceof FetchException fetch ? fetch.waitMillis() : 0;
        failures++;
        last = error;
        if (failures < options.attempts()) return;
        if (error instanceof FetchException) throw error;
        String what = "the connection failed " + failures + " times in a row (" + describe(error) + ")";
        throw FetchException.passing(
                source.name(),
                what,
                "check the network and ask again: the " + archive.bytes() + " bytes received are kept",
                error);
    }

    private static boolean isUnknownHost(Throwable error) {
        for (Throwable t = error; t != null; t = t.getCause()) {
            if (t instanceof UnresolvedAddressException || t instanceof UnknownHostException) return true;
        }
        return false;
    }

    private static String describe(IOException error) {
        String text = error.getMessage() == null ? error.getClass().getSimpleName() : error.getMessage();
        return text.isEmpty() ? error.getClass().getSimpleName() : text;
    }

    /** Waits after a failure; false when the deadline comes before the pause is over. */
    boolean pause(double deadlineMillis, BooleanSupplier cancelled) {
        if (failures == 0 || askedToWaitMillis == FetchException.AT_ONCE) return true;
        double pause = Math.max(askedToWaitMillis, options.backoffMillis() * (double) (1 << Math.min(failures - 1, 4)));
        double left = deadlineMillis - clock.millis();
        impatience.forget();
        pausing.heard(last, failures + 1, pause < left ? (long) pause : -1);
        Waiting.pause(Math.min(pause, left), impatience, cancelled);
        return pause < left || impatience.getAsBoolean();
    }

    /** Ends the pause that there is now. On any thread. */
    void tryNow() {
        impatience.show();
    }
}
