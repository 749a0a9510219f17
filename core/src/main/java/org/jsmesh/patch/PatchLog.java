package org.jsmesh.patch;

import java.util.Arrays;

/**
 * The collapses of a simplification in the order in which they were made, grouped in passes, with what is needed to
 * undo each. These are the patches of the paper's section 5.1 before they are coded. Ids are those of the mesh that was
 * simplified.
 *
 * <p>Patch p removed vertex {@code removed(p)} into {@code kept(p)} together with the faces {@code leftFace(p)} and
 * {@code rightFace(p)} on the two sides of their edge. The other faces of the removed vertex, {@code runLength(p)} of
 * them counter-clockwise about the kept vertex from {@code runFace(p)}, became faces of the kept vertex.
 *
 * <p>After the collapses of a pass, components of the mesh that no patch of the pass touched may have been removed
 * whole.
 */
public final class PatchLog {
    private static final int FIELDS = 7;
    private static final int BLOCK_BITS = 14;
    private static final int IN_BLOCK = (1 << BLOCK_BITS) - 1;
    private int[][] blocks = {new int[FIELDS * 256]
    }; // of 2^14 patches, the last one perhaps of fewer; null when forgotten
    private int size;
    private int[] wedges = new int[256];
    private int wedgeCount;
    private int[] passStarts = new int[64];
    private int[] passLevels = new int[64];
    private int passes;
    private int[] components = new int[64]; // a face and the vertices of each that was removed
    private int componentCount;
    private int[] componentStarts = new int[64]; // of each pass
    private double[] thresholds = {};

    /**
     * Starts a pass; the following patches belong to it. The stars of the vertices removed in one pass share no face.
     */
    public void beginPass(int level) {
        if (passes == passStarts.length) {
            passStarts = Arrays.copyOf(passStarts, 2 * passes);
            passLevels = Arrays.copyOf(passLevels, 2 * passes);
            componentStarts = Arrays.copyOf(componentStarts, 2 * passes);
        }
        passStarts[passes] = size;
        componentStarts[passes] = componentCount;
        passLevels[passes++] = level;
    }

    /** Appends a patch without the wedges of its run, which follow through {@link #addRunWedge}. */
    public void add(int removed, int kept, int leftFace, int rightFace, int runFace, int runLength) {
        int at = FIELDS * (size & IN_BLOCK);
        int[] rows = blockWithRoom(at);
        rows[at] = removed;
        rows[at + 1] = kept;
        rows[at + 2] = leftFace;
        rows[at + 3] = rightFace;
        rows[at + 4] = runFace;
        rows[at + 5] = runLength;
        rows[at + 6] = wedgeCount;
        size++;
    }

    /** Notes that a component was removed in this pass. */
    public void addComponent(int face, int vertices) {
        int at = 2 * componentCount++;
        if (at == components.length) components = Arrays.copyOf(components, 2 * at);
        components[at] = face;
        components[at + 1] = vertices;
    }

    private int[] blockWithRoom(int at) {
        int block = size >> BLOCK_BITS;
        if (block == blocks.length) blocks = Arrays.copyOf(blocks, 2 * block);
        if (blocks[block] == null) blocks[block] = new int[FIELDS << BLOCK_BITS];
        if (at == blocks[block].length) blocks[block] = Arrays.copyOf(blocks[block], 2 * at);
        return blocks[block];
    }

    /**
     * Forgets the patches from one on that fill blocks, because the last in the log are undone first. Their passes and
     * wedges stay known.
     */
    public void forget(int patch) {
        int block = patch + IN_BLOCK >> BLOCK_BITS;
        for (; block < blocks.length; block++) blocks[block] = null;
    }

    private int field(int patch, int field) {
        return blocks[patch >> BLOCK_BITS][FIELDS * (patch & IN_BLOCK) + field];
    }

    /** Adds the wedge that the removed vertex had in the next face of the run of the patch last added. */
    public void addRunWedge(int wedge) {
        if (wedgeCount == wedges.length) wedges = Arrays.copyOf(wedges, 2 * wedgeCount);
        wedges[wedgeCount++] = wedge;
    }

    /**
     * Sorts the patches by pass, and within a pass by their order so far; replaces all passes. No component may have
     * been removed.
     *
     * @param passOf pass of each patch, so that the patches can be undone in the new order as well
     * @param levelOf level of each pass, ascending
     */
    public void arrange(int[] passOf, int[] levelOf) {
        passes = levelOf.length;
        passLevels = levelOf.clone();
        passStarts = new int[passes + 1];
        componentStarts = new int[passes + 1];
        for (int p = 0; p < size; p++) if (passOf[p] + 1 < passes) passStarts[passOf[p] + 1]++;
        for (int pass = 1; pass < passes; pass++) passStarts[pass] += passStarts[pass - 1];
        int[] next = passStarts.clone();
        int[][] sorted = new int[blocks.length][];
        for (int block = 0; block < blocks.length; block++)
            if (blocks[block] != null) sorted[block] = new int[blocks[block].length];
        for (int p = 0; p < size; p++) {
            int to = next[passOf[p]]++;
            System.arraycopy(
                    blocks[p >> BLOCK_BITS],
                    FIELDS * (p & IN_BLOCK),
                    sorted[to >> BLOCK_BITS],
                    FIELDS * (to & IN_BLOCK),
                    FIELDS);
        }
        blocks = sorted;
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

    /** Components that were removed, in all passes. */
    public int components() {
        return componentCount;
    }

    /** First component of a pass, or {@link #components} for the pass after the last. */
    public int componentStart(int pass) {
        return pass == passes ? componentCount : componentStarts[pass];
    }

    /** A face of a component, removed with it. */
    public int componentFace(int component) {
        return components[2 * component];
    }

    /** Patches and components of a pass, all that there is to undo. */
    public int steps(int pass) {
        return passStart(pass + 1) - passStart(pass) + componentStart(pass + 1) - componentStart(pass);
    }

    /** Vertices that come back when a pass is undone; each fan of a vertex counts. */
    public int vertices(int pass) {
        int sum = passStart(pass + 1) - passStart(pass);
        for (int i = componentStart(pass); i < componentStart(pass + 1); i++) sum += components[2 * i + 1];
        return sum;
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
        return field(patch, 0);
    }

    public int kept(int patch) {
        return field(patch, 1);
    }

    public int leftFace(int patch) {
        return field(patch, 2);
    }

    public int rightFace(int patch) {
        return field(patch, 3);
    }

    public int runFace(int patch) {
        return field(patch, 4);
    }

    public int runLength(int patch) {
        return field(patch, 5);
    }

    /** The wedge of the removed vertex in face {@code i} of the run. Only where wedges were logged. */
    public int runWedge(int patch, int i) {
        return wedges[field(patch, 6) + i];
    }
}
