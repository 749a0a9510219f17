package org.jsmesh.sandbox;

/**
 * What the encoding of one model may take.
 *
 * @param heapMegabytes of the process, in MiB
 * @param encodeMillis from its start to its end
 * @param mostFaces of the model
 * @param mostBytes of a packed model and its companions, unpacked
 * @param threads that encode it
 */
public record SandboxLimits(int heapMegabytes, long encodeMillis, int mostFaces, long mostBytes, int threads) {
    private static final int LEAST_MEGABYTES = 32;

    /**
     * Checks the limits.
     *
     * @param heapMegabytes see {@link #heapMegabytes()}
     * @param encodeMillis see {@link #encodeMillis()}
     * @param mostFaces see {@link #mostFaces()}
     * @param mostBytes see {@link #mostBytes()}
     * @param threads see {@link #threads()}
     * @throws IllegalArgumentException when a number is below 1, or the heap below 32 MiB
     */
    public SandboxLimits {
        if (heapMegabytes < LEAST_MEGABYTES)
            throw new IllegalArgumentException(
                    "MiB of the encoder: " + heapMegabytes + ", at least " + LEAST_MEGABYTES);
        if (encodeMillis < 1) throw new IllegalArgumentException("milliseconds of encoding: " + encodeMillis);
        if (mostFaces < 1) throw new IllegalArgumentException("faces of a model: " + mostFaces);
        if (mostBytes < 1) throw new IllegalArgumentException("bytes of a model: " + mostBytes);
        if (threads < 1) throw new IllegalArgumentException("threads of the encoder: " + threads);
    }

    /** {@return limits of as much heap as this process may take, one hour, 100 million faces, and 2 GiB unpacked} */
    public static SandboxLimits defaults() {
        long megabytes = Math.min(Integer.MAX_VALUE, Runtime.getRuntime().maxMemory() >> 20);
        int threads = Math.max(1, Runtime.getRuntime().availableProcessors() / 2);
        return new SandboxLimits((int) Math.max(LEAST_MEGABYTES, megabytes), 3_600_000, 100_000_000, 2L << 30, threads);
    }

    /**
     * Changes the memory of the process.
     *
     * @param megabytes of its heap, in MiB, at least 32
     * @return limits that differ in that alone
     */
    public SandboxLimits withHeapMegabytes(int megabytes) {
        return new SandboxLimits(megabytes, encodeMillis, mostFaces, mostBytes, threads);
    }

    /**
     * Changes how long encoding one model may take.
     *
     * @param millis at least 1
     * @return limits that differ in that alone
     */
    public SandboxLimits withEncodeMillis(long millis) {
        return new SandboxLimits(heapMegabytes, millis, mostFaces, mostBytes, threads);
    }

    /**
     * Changes how many faces a model may have.
     *
     * @param faces at least 1
     * @return limits that differ in that alone
     */
    public SandboxLimits withMostFaces(int faces) {
        return new SandboxLimits(heapMegabytes, encodeMillis, faces, mostBytes, threads);
    }

    /**
     * Changes what a packed model may unpack to.
     *
     * @param bytes at least 1
     * @return limits that differ in that alone
     */
    public SandboxLimits withMostBytes(long bytes) {
        return new SandboxLimits(heapMegabytes, encodeMillis, mostFaces, bytes, threads);
    }
}
