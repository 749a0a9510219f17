package org.jsmesh.desktop.chart;

import java.util.Arrays;

/**
 * How a model was loaded: bytes, faces and error over the time of loading. What passes between two rounds takes no time
 * in it. When it is full, every second sample goes, so that it never grows beyond {@value #MOST} samples. A model that
 * begins again begins a new record. Thread-safe.
 */
public final class LoadRecord {
    /** Samples at most. */
    static final int MOST = 4096;

    private double[] seconds = new double[64];
    private long[] bytes = new long[64];
    private int[] faces = new int[64];
    private double[] errors = new double[64];
    private int size;
    private int sinceHalving;
    private int stride = 1;
    private long lastMillis = -1;
    private long lastReceived;
    private long outside;
    private double elapsed;
    /** When a sample last told nothing new. */
    private double quiet;

    /** Nothing has been loaded. */
    public LoadRecord() {}

    /**
     * Notes how far loading is.
     *
     * @param millis a clock's time, never less than the one before
     * @param loading whether a round is under way; time up to a sample outside of rounds does not count
     * @param received bytes of the archive
     * @param facesNow shown
     * @param errorMean mean distance to the original, in % of the diagonal
     */
    public synchronized void sample(long millis, boolean loading, long received, int facesNow, double errorMean) {
        if (received < lastReceived) clear();
        boolean counts = lastMillis >= 0;
        // What came between two rounds took no time of theirs.
        if (!counts && size > 0) outside += received - lastReceived;
        lastReceived = received;
        long bytesNow = received - outside;
        if (counts) elapsed += Math.max(0, millis - lastMillis) / 1000.0;
        lastMillis = loading ? millis : -1;
        boolean isNew = size == 0 || bytes[size - 1] != bytesNow || faces[size - 1] != facesNow;
        if (!isNew) {
            quiet = elapsed;
            return;
        }
        // What comes after a pause did not trickle in during it.
        if (stride == 1 && size > 0 && size < MOST && quiet > seconds[size - 1]) {
            if (size == seconds.length) grow();
            put(size, bytes[size - 1], faces[size - 1], errors[size - 1]);
            seconds[size++] = quiet;
        }
        if (size > 0 && sinceHalving++ % stride != 0 && seconds[size - 1] > 0) {
            // The newest sample stands for those that were left out.
            put(size - 1, bytesNow, facesNow, errorMean);
            return;
        }
        if (size == MOST) halve();
        if (size == seconds.length) grow();
        put(size++, bytesNow, facesNow, errorMean);
    }

    private void clear() {
        size = 0;
        sinceHalving = 0;
        stride = 1;
        lastMillis = -1;
        lastReceived = 0;
        outside = 0;
        elapsed = 0;
        quiet = 0;
    }

    private void put(int at, long bytesNow, int facesNow, double errorMean) {
        seconds[at] = elapsed;
        bytes[at] = bytesNow;
        faces[at] = facesNow;
        errors[at] = errorMean;
    }

    private void grow() {
        int next = Math.min(MOST, 2 * size);
        seconds = Arrays.copyOf(seconds, next);
        bytes = Arrays.copyOf(bytes, next);
        faces = Arrays.copyOf(faces, next);
        errors = Arrays.copyOf(errors, next);
    }

    private void halve() {
        for (int i = 0; 2 * i < size; i++) {
            // The later one of each pair: the record keeps its end.
            int from = 2 * i + 1;
            seconds[i] = seconds[from];
            bytes[i] = bytes[from];
            faces[i] = faces[from];
            errors[i] = errors[from];
        }
        size /= 2;
        stride *= 2;
        sinceHalving = 0;
    }

    /** {@return how long was loaded} */
    public synchronized double seconds() {
        return elapsed;
    }

    /** {@return the number of samples} */
    synchronized int size() {
        return size;
    }

    /**
     * Cuts the time of loading into equal parts.
     *
     * @param count of the parts
     * @return bytes per second in each
     */
    synchronized double[] rates(int count) {
        double[] rates = new double[count];
        double length = elapsed / count;
        if (length <= 0) return rates;
        double before = size == 0 ? 0 : bytes[0];
        for (int part = 0; part < count; part++) {
            double there = bytesAt((part + 1) * length);
            rates[part] = (there - before) / length;
            before = there;
        }
        return rates;
    }

    /** Bytes at a time, between two samples in proportion. */
    private double bytesAt(double second) {
        int after = 0;
        while (after < size && seconds[after] < second) after++;
        if (after == 0) return size == 0 ? 0 : bytes[0];
        if (after == size) return bytes[size - 1];
        double span = seconds[after] - seconds[after - 1];
        double share = span <= 0 ? 1 : (second - seconds[after - 1]) / span;
        return bytes[after - 1] + share * (bytes[after] - bytes[after - 1]);
    }

    /** {@return faces at the end of each of so many equal parts of the time} */
    synchronized int[] faces(int count) {
        int[] shown = new int[count];
        for (int part = 0; part < count; part++) {
            int at = last((part + 1) * elapsed / count);
            shown[part] = at < 0 ? 0 : faces[at];
        }
        return shown;
    }

    /** {@return the error at the end of each part, NaN where nothing is shown} */
    synchronized double[] errors(int count) {
        double[] shown = new double[count];
        for (int part = 0; part < count; part++) {
            int at = last((part + 1) * elapsed / count);
            shown[part] = at < 0 || faces[at] == 0 ? Double.NaN : errors[at];
        }
        return shown;
    }

    /** The last sample up to a time, with what rounding takes from it; −1 for none. */
    private int last(double second) {
        int at = size - 1;
        while (at >= 0 && seconds[at] > second + 1e-9) at--;
        return at;
    }
}
