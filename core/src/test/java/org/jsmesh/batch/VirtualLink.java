package org.jsmesh.batch;

import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.jsmesh.throughput.ResponseSamples;

/** A link in virtual time: a rate that changes, a round-trip time, and the slow start of TCP. Bytes on the wire when a response is cancelled are counted as wasted. */
final class VirtualLink {
    private static final double STEP_MILLIS = 5;
    private static final double FIRST_WINDOW_BYTES = 14600;
    private final DoubleUnaryOperator bytesPerSecondAt;
    private final double roundTripMillis;
    private double congestionWindow;
    private double lastUseMillis;
    private boolean connected;
    double now;
    long wastedBytes;

    VirtualLink(DoubleUnaryOperator bytesPerSecondAt, double roundTripMillis) {
        this.bytesPerSecondAt = bytesPerSecondAt;
        this.roundTripMillis = roundTripMillis;
    }

    /** Decides whether a response goes on. */
    interface Reader {
        boolean goesOn(double now, long bytesLeft, ResponseSamples response);
    }

    /** Reads a response until it ends or the reader stops it; the clock moves on. */
    ResponseSamples read(long bytes, Reader reader) {
        ResponseSamples response = new ResponseSamples(now);
        if (!connected || now - lastUseMillis > 1000) congestionWindow = FIRST_WINDOW_BYTES;
        if (!connected) now += roundTripMillis;
        connected = true;
        now += roundTripMillis;
        double credit = 0;
        while (response.bytes() < bytes) {
            long left = bytes - response.bytes();
            if (!reader.goesOn(now, left, response)) {
                wastedBytes += Math.min(left, (long) Math.max(4096, rate(now) * roundTripMillis / 1000));
                connected = false;
                return response;
            }
            double rate = Math.min(rate(now), congestionWindow * 1000 / roundTripMillis);
            double delivered = rate * STEP_MILLIS / 1000;
            congestionWindow +=
                    Math.min(delivered, Math.max(0, rate(now) * roundTripMillis / 1000 * 2 - congestionWindow));
            now += STEP_MILLIS;
            credit += delivered;
            int whole = (int) Math.min(left, (long) credit);
            if (whole > 0) response.arrived(now, whole);
            credit -= whole;
        }
        lastUseMillis = now;
        return response;
    }

    /** Bytes that a client which knows the future gets between two times on a warm connection. */
    double possible(double fromMillis, double toMillis) {
        double bytes = 0;
        for (double t = fromMillis + roundTripMillis; t < toMillis; t += STEP_MILLIS)
            bytes += rate(t) * STEP_MILLIS / 1000;
        return bytes;
    }

    private double rate(double atMillis) {
        return bytesPerSecondAt.applyAsDouble(atMillis);
    }

    static DoubleUnaryOperator constant(double bitsPerSecond) {
        return t -> bitsPerSecond / 8;
    }

    /** Alternates between two rates. */
    static DoubleUnaryOperator steps(
            double firstBitsPerSecond, double secondBitsPerSecond, double periodMillis, double phaseMillis) {
        return t -> ((long) ((t + phaseMillis) / periodMillis) % 2 == 0 ? firstBitsPerSecond : secondBitsPerSecond) / 8;
    }

    /** Mean rate × a lognormal factor of sigma 1, drawn anew every 500 ms and correlated with the one before. */
    static DoubleUnaryOperator lognormal(double meanBitsPerSecond, long seed) {
        Random random = new Random(seed);
        double[] rates = new double[1024];
        double x = random.nextGaussian();
        for (int i = 0; i < rates.length; i++) {
            rates[i] = meanBitsPerSecond / 8 * Math.exp(x - 0.5);
            x = 0.8 * x + 0.6 * random.nextGaussian();
        }
        return t -> rates[(int) (t / 500) % rates.length];
    }
}
