package org.jsmesh.app.heap;

import java.util.List;

/**
 * Decides whether a command is done better with another heap than the one that Java took by itself, a quarter of the
 * memory.
 *
 * @param heapBytes that this process may take
 * @param machineBytes of memory of the machine, or of its container
 * @param isChosen whether the user has set the heap
 */
public record HeapPlan(long heapBytes, long machineBytes, boolean isChosen) {
    private static final double USED = .75; // of a heap, by what it is made for
    private static final double ENOUGH = .85; // of the heap that is there
    private static final double MOST_OF_MACHINE = .8;
    private static final double LEAST_GAIN = 1.15; // less would not be worth the start of another process
    private static final double SAME = .03;
    private static final long STEP = 64 << 20;
    private static final List<String> SIZES =
            List.of("-Xmx", "-mx", "-XX:MaxHeapSize=", "-XX:MaxRAMPercentage=", "-XX:MaxRAMFraction=");

    private static final List<String> FIRST_SIZES = List.of("-Xms", "-ms", "-XX:InitialHeapSize=", "-XX:MinHeapSize=");

    /** Whether one of Java's options sets the heap. */
    static boolean isHeapSet(List<String> options) {
        return options.stream().anyMatch(option -> SIZES.stream().anyMatch(option::startsWith));
    }

    /** Whether one of Java's options sets the heap to begin with, which may be more than another heap has at most. */
    static boolean isFirstSizeSet(List<String> options) {
        return options.stream().anyMatch(option -> FIRST_SIZES.stream().anyMatch(option::startsWith));
    }

    /** {@return the bytes of heap that are given at most, so that something of the machine is left} */
    public long mostBytes() {
        return (long) (MOST_OF_MACHINE * machineBytes);
    }

    /**
     * The heap for some work.
     *
     * @param needBytes that the work takes
     * @param leastBytes without which it cannot be done
     * @return bytes of the heap to start again with, or 0 to go on as it is
     */
    public long forWork(long needBytes, long leastBytes) {
        if (isChosen || needBytes <= ENOUGH * heapBytes) return 0;
        long most = mostBytes();
        if (leastBytes > most) return 0; // it will be told what is missing
        long heap = Math.min(most, ((long) (needBytes / USED) / STEP + 1) * STEP);
        return heap < LEAST_GAIN * heapBytes ? 0 : heap;
    }

    /**
     * The heap that the user wants.
     *
     * @param wanted by an option of the command
     * @return bytes of the heap to start again with, or 0 when this process has that already
     */
    public long forUser(HeapSize wanted) {
        return Math.abs(wanted.bytes() - heapBytes) <= SAME * wanted.bytes() ? 0 : wanted.bytes();
    }
}
