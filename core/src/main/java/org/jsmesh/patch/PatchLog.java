package org.jsmesh.patch;

import java.util.Arrays;

/**
 * The collapses of a simplification in the order they were made, grouped in passes, with what is needed to undo each: the patches of the paper's section 5.1 before they
 * are coded. Ids are those of the mesh that was simplified.
 *
 * <p>Patch p removed vertex {@code removed(p)} into {@code kept(p)} together with the faces {@code leftFace(p)} and {@code rightFace(p)} on the two sides of their edge.
 * The other faces of the removed vertex, {@code runLength(p)} of them counter-clockwise about the kept vertex from {@code runFace(p)}, became faces of the kept vertex.
 */
public final class PatchLog {
    private static final int FIELDS = 7;
    private int[] rows = new int[FIELDS * 256];
    private int size;
    private int[] wedges = new int[256];
    private int wedgeCount;
    private int[] passStarts = new int[64];
    private int[] passLevels = new int[64];
    private int passes;
    private double[] thresholds = {};

    /** Starts a pass; the following patches belong to it. The stars of the vertices removed in one pass share no face. */
    public void beginPass(int level) {
        if (passes == passStarts.length) {
            passStarts = Arrays.copyOf(passStarts, 2 * passes);
            passLevels = Arrays.copyOf(passLevels, 2 * passes);
        }
        passStarts[passes] = size;
        passLevels[passes++] = level;
    }

    /** Appends a patch without the wedges of its run, which follow through {@link #addRunWedge}. */
    public void add(int removed, int kept, int leftFace, int rightFace, int runFace, int runLength) {
        int at = FIELDS * size;
        if (at == rows.length) rows = Arrays.copyOf(rows, 2 * at);
        rows[at] = removed;
        rows[at + 1] = kept;
        rows[at + 2] = leftFace;
        rows[at + 3] = rightFace;
        rows[at + 4] = runFace;
        rows[at + 5] = runLength;
        rows[at + 6] = wedgeCount;
        size++;
    }

    /** The wedge that the removed vertex had in the next face of the run of the patch last added. */
    public void addRunWedge(int wedge) {
        if (wedgeCount == wedges.length) wedges = Arrays.copyOf(wedges, 2 * wedgeCount);
        wedges[wedgeCount++] = wedge;
    }

    /**
     * Sorts the patches by pass, and within a pass by their order so far; replaces all passes.
     *
     * @param passOf pass of each patch, so that the patches can be undone in the new order as well
     * @param levelOf level of each pass, ascending
     */
    public void arrange(int[] passOf, int[] levelOf) {
        passes = levelOf.length;
        passLevels = levelOf.clone();
        passStarts = new int[passes + 1];
        for (int p = 0; p < size; p++) if (passOf[p] + 1 < passes) passStarts[passOf[p] + 1]++;
        for (int pass = 1; pass < passes; pass++) passStarts[pass] += passStarts[pass - 1];
        int[] next = passStarts.clone();
        int[] sorted = new int[rows.length];
        for (int p = 0; p < size; p++) System.arraycopy(rows, FIELDS * p, sorted, FIELDS * next[passOf[p]]++, FIELDS);
        rows = sorted;
    }

    public int size() {
        return size;
    }

    public int passes() {
        return passes;
    }

    /** First patch of a pass, or {@link #size} for the pass after the last. */
    public int passStart(int pass) {
        return pass == passes ? size : passStarts[pass];
    }

    /** The level that a pass belongs to, counted from 0 at the original. */
    public int passLevel(int pass) {
        return passLevels[pass];
    }

    /** Sets the cost up to which collapses belong to each level, from the original's level 0. */
    public void setThresholds(double[] costs) {
        thresholds = costs.clone();
    }

    /** Cost up to which collapses belong to a level. The unit is the simplifier's. */
    public double threshold(int level) {
        return thresholds[level];
    }

    /** Levels, without those above the last pass. */
    public int levels() {
        return passes == 0 ? 0 : passLevels[passes - 1] + 1;
    }

    public int removed(int patch) {
        return rows[FIELDS * patch];
    }

    public int kept(int patch) {
        return rows[FIELDS * patch + 1];
    }

    public int leftFace(int patch) {
        return rows[FIELDS * patch + 2];
    }

    public int rightFace(int patch) {
        return rows[FIELDS * patch + 3];
    }

    public int runFace(int patch) {
        return rows[FIELDS * patch + 4];
    }

    public int runLength(int patch) {
        return rows[FIELDS * patch + 5];
    }

    /** The wedge of the removed vertex in face {@code i} of the run. Only where wedges were logged. */
    public int runWedge(int patch, int i) {
        return wedges[rows[FIELDS * patch + 6] + i];
    }
}
