package org.jsmesh.memory;

/** A model needs more heap than this process may take. Nothing of it was read but its header. */
public final class HeapShortageException extends RuntimeException {
    private static final long serialVersionUID = 1;
    private static final double WARNED = .85;
    private static final int STEPS = 2; // of a GiB, in advice

    private final long needBytes;
    private final long limitBytes;

    /**
     * Makes an exception.
     *
     * @param needBytes of heap that are enough in nearly all cases
     * @param limitBytes that this process may take
     */
    public HeapShortageException(long needBytes, long limitBytes) {
        super(needs(needBytes, limitBytes) + ". " + remedy(needBytes));
        this.needBytes = needBytes;
        this.limitBytes = limitBytes;
    }

    /** {@return bytes of heap that are enough in nearly all cases} */
    public long needBytes() {
        return needBytes;
    }

    /** {@return bytes of heap that this process may take} */
    public long limitBytes() {
        return limitBytes;
    }

    /** {@return what is wrong, without remedy} */
    public String reason() {
        return needs(needBytes, limitBytes);
    }

    /** {@return what helps on a machine with enough memory} */
    public String remedy() {
        return remedy(needBytes);
    }

    /**
     * Refuses work that cannot be done with the heap of this process.
     *
     * @param estimate of the work
     * @throws HeapShortageException when even the least that the work takes is more than this process may take
     */
    public static void check(MemoryEstimate estimate) {
        long limit = Runtime.getRuntime().maxMemory();
        if (estimate.leastBytes() > limit) throw new HeapShortageException(estimate.bytes(), limit);
    }

    /**
     * Words for work that may just not be possible with some heap.
     *
     * @param estimate of the work
     * @param limitBytes of the heap
     * @return reason and remedy, or null where at most 85% of the heap is needed
     */
    public static String warning(MemoryEstimate estimate, long limitBytes) {
        if (estimate.bytes() <= WARNED * limitBytes) return null;
        return "may need " + amount(estimate.bytes()) + " of heap memory, and the limit is " + amount(limitBytes) + ". "
                + remedy(estimate.bytes()) + " if it fails.";
    }

    private static String needs(long need, long limit) {
        return "needs about " + amount(need) + " of heap memory, and the limit is " + amount(limit);
    }

    private static String remedy(long need) {
        String size = size((long) (need / WARNED));
        return "Give Java more: --max-heap " + size + " of 'jsm encode', or -Xmx" + size;
    }

    private static String amount(long bytes) {
        double gigabytes = bytes / (double) (1 << 30);
        return gigabytes < 1 ? (bytes >> 20) + " MiB" : Math.round(10 * gigabytes) / 10.0 + " GiB";
    }

    /** As options of Java take it, rounded up. */
    private static String size(long bytes) {
        long halves = (bytes * STEPS >> 30) + 1;
        return halves % STEPS == 0 ? halves / STEPS + "g" : halves * (1024 / STEPS) + "m";
    }
}
