package org.jsmesh.archive.coding;

import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.BatchIndexBuilder;
import org.jsmesh.archive.BatchKind;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.IntegerModel;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * Codes the batch index in both directions, each row as its difference from a prediction by the rows before. The rows
 * come in two streams: those of the first batches in the opening of the file, the others in the batch that ends the
 * header.
 */
public final class IndexCoder {
    private static final int MAX_BATCHES = 1 << 24;
    private static final int MAX_SHIFT = 28;
    /** Bits of precision that stand for exact positions. */
    public static final int EXACT = 32;

    private static final int KIND = 1;
    private static final int NEW_PASS = 2;
    private static final int DROP = 3;
    private static final int NEW_LEVEL = 4;
    private static final BatchKind[] KINDS = {
        BatchKind.SPLITS,
        BatchKind.TEXTURE,
        BatchKind.PRECISION,
        BatchKind.ATTRIBUTES,
        BatchKind.ORDER,
        BatchKind.PREVIEW,
        BatchKind.REMAINDER,
        BatchKind.POSTER
    };
    private final BatchIndex source;
    private final boolean write;
    private BinaryCoder coder;
    private final IntegerModel flags = new IntegerModel(5);
    private final IntegerModel bytes = new IntegerModel(6);
    private final IntegerModel patches = new IntegerModel(3);
    private final IntegerModel faces = new IntegerModel(3);
    private final IntegerModel errors = new IntegerModel(4);
    private final BatchIndexBuilder rows = new BatchIndexBuilder();
    private final int extentBits;
    private final boolean hasStitches;
    private final boolean hasComponents;
    private int row; // of the source
    private int faceCount;
    private int vertexCount;
    private int step; // of the mean error
    private int bound; // half the step of the bound
    private int shift;
    private int coarsest;
    private int refined;
    private boolean attributes;
    private boolean poster;
    private int level;
    private int pass;
    private long end; // of the payloads, without the head and the header's rest
    private final double[] bytesPerPatch = {4, 1, 8}; // of the last batch of splits, of precision, of attributes

    /**
     * @param source the index without the row of the batch that ends the header; null for a decoder
     * @param extentBits bits of the longest side of the bounding box in cells
     * @param hasStitches may splits make further fans of vertices that are there?
     * @param hasComponents may components come after the base?
     */
    IndexCoder(BatchIndex source, int extentBits, boolean hasStitches, boolean hasComponents) {
        this.source = source;
        this.extentBits = extentBits;
        this.hasStitches = hasStitches;
        this.hasComponents = hasComponents;
        write = source != null;
    }

    /**
     * Codes the row of the base.
     *
     * @param headBytes bytes in front of the base payload: known to the decoder alone
     */
    void codeBase(BinaryCoder stream, int headBytes) throws MalformedStreamException {
        coder = stream;
        int baseBytes = bytes.unsigned(coder, 0, write ? source.bytes(0) : 0);
        if (baseBytes < ArchiveLayout.CRC_BYTES || baseBytes > Integer.MAX_VALUE - headBytes)
            throw new MalformedStreamException(-1, "a base of " + baseBytes + " bytes");
        end = baseBytes;
        vertexCount = bounded(faces.unsigned(coder, write ? source.vertices(0) : 0));
        faceCount = bounded(
                2L * vertexCount - faces.signed(coder, 0, write ? 2 * source.vertices(0) - source.faces(0) : 0));
        step = errors.unsigned(coder, write ? ErrorScale.closest(source.errorMean(0)) : 0);
        checkError();
        if (step < ErrorScale.ZERO) bound = step / 2 - errors.unsigned(coder, 2, write ? step / 2 - boundStep(0) : 0);
        if (bound < 0) throw malformed("has a bound out of range");
        shift = coder.raw(write ? source.shift(0) : 0, 5);
        if (shift > MAX_SHIFT) throw new MalformedStreamException(-1, "positions in units of 2^" + shift);
        coarsest = shift;
        rows.add(BatchKind.BASE, headBytes + baseBytes, 0);
        completeRow();
        row = 1;
    }

    /** Codes how many rows follow, and these rows. */
    void codeRows(BinaryCoder stream, int count) throws MalformedStreamException {
        coder = stream;
        int n = flags.unsigned(coder, 0, count);
        if (n < 0 || n > MAX_BATCHES) throw new MalformedStreamException(-1, n + " batches");
        for (int i = 0; i < n; i++, row++) {
            if (coder.isExhausted()) throw new MalformedStreamException(-1, "the index ends early");
            codeRow();
        }
    }

    /** Codes the quantiles of the errors of all rows. */
    void codeQuantiles(BinaryCoder stream) throws MalformedStreamException {
        new QuantileColumn(source, rows).code(stream);
    }

    /** Adds the row of the batch that ends the header, which is not in the source. */
    void addHeaderRow(int size) {
        rows.add(BatchKind.HEADER, size, 0);
        completeRow();
    }

    /** The rows so far. */
    BatchIndex build() {
        return rows.build();
    }

    /** @throws MalformedStreamException when rows are missing */
    void checkEnd() throws MalformedStreamException {
        if (coarsest > 0 || refined > 0)
            throw new MalformedStreamException(-1, "the index ends before the positions are exact");
    }

    private void codeRow() throws MalformedStreamException {
        int i = row;
        BatchKind kind = kind(flags.unsigned(coder, KIND, write ? number(source.kind(i)) : 0));
        boolean splits = kind == BatchKind.SPLITS;
        int begun = splits ? flags.unsigned(coder, NEW_PASS, write ? source.pass(i) - pass : 0) : 0;
        pass = bounded((long) pass + begun);
        if (begun > 0)
            level = bounded(level + (long) flags.unsigned(coder, NEW_LEVEL, write ? source.level(i) - level : 0));
        int size = codeSize(kind);
        if (poster) throw malformed("comes after the poster");
        poster = kind == BatchKind.POSTER;
        if (attributes && splits) throw malformed("comes after exact attributes");
        int patchCount = 0;
        int before = vertexCount;
        if (kind == BatchKind.ATTRIBUTES) {
            attributes = true;
            patchCount = codePatches(2, size, Integer.MAX_VALUE / 8);
            if (refined > 0) throw malformed("comes amid a sweep");
        } else if (kind == BatchKind.PRECISION) {
            int drop = codeDrop();
            patchCount = codePatches(1, size, vertexCount - refined);
            if (refined > 0 && drop > 0) throw malformed("begins amid a sweep");
            if (coarsest == 0) throw malformed("refines what is exact");
            refined += patchCount;
            if (refined > vertexCount) throw malformed("refines what is not there");
            if (refined == vertexCount) {
                refined = 0;
                coarsest = shift;
            }
        } else if (splits) {
            if (refined > 0) throw malformed("splits amid a sweep");
            if (begun > 0) {
                codeDrop();
                coarsest = shift;
            }
            patchCount = codeSplits(size);
        }
        int expected = vertexCount == before ? step : ErrorScale.step(ErrorScale.value(step) * before / vertexCount);
        step = expected + errors.signed(coder, 1, write ? ErrorScale.closest(source.errorMean(i)) - expected : 0);
        checkError();
        if (step < ErrorScale.ZERO) bound += errors.unsigned(coder, 3, write ? boundStep(i) - bound : 0);
        if (bound < 0 || bound > ErrorScale.ZERO / 2) throw malformed("has a bound out of range");
        rows.add(kind, size, patchCount);
        completeRow();
    }

    private int boundStep(int batch) {
        return ErrorScale.step(source.errorBound(batch)) / 2;
    }

    private void checkError() throws MalformedStreamException {
        if (step < 0 || step > ErrorScale.ZERO) throw malformed("has an error out of range");
    }

    private int codeSize(BatchKind kind) throws MalformedStreamException {
        int cap = cap(end);
        int statistics = switch (kind) {
            case TEXTURE, ORDER, REMAINDER, POSTER -> 3;
            case PREVIEW -> 2;
            case ATTRIBUTES -> 5;
            case PRECISION -> 4;
            default -> 1;
        };
        int size = cap - bytes.signed(coder, statistics, write ? cap - source.bytes(row) : 0);
        if (size < ArchiveLayout.CRC_BYTES || size > 1 << 20) throw malformed("has " + size + " bytes");
        end += size;
        return size;
    }

    /** By how many bits the shift falls. */
    private int codeDrop() throws MalformedStreamException {
        int drop = flags.unsigned(coder, DROP, write ? shift - source.shift(row) : 0);
        if (drop > shift) throw malformed("refines what is exact");
        shift -= drop;
        return drop;
    }

    /** Codes a number of patches as its difference from a prediction by the last batch of the sort. */
    private int codePatches(int sort, int size, int most) throws MalformedStreamException {
        int expected = (int) Math.min(most, size / bytesPerPatch[sort]);
        int count = bounded(expected + (long) patches.signed(coder, sort, write ? source.patches(row) - expected : 0));
        if (count > 0) bytesPerPatch[sort] = size / (double) count;
        return count;
    }

    private int codeSplits(int size) throws MalformedStreamException {
        int count = codePatches(0, size, Integer.MAX_VALUE / 8);
        int fewer = codeMissing(1, write ? 2 * count - (source.faces(row) - source.faces(row - 1)) : 0);
        faceCount = bounded((long) faceCount + 2L * count - fewer);
        int fewerVertices = 0;
        if (hasStitches || hasComponents)
            fewerVertices = codeMissing(2, write ? count - (source.vertices(row) - source.vertices(row - 1)) : 0);
        if (fewerVertices > count) throw malformed("loses vertices");
        vertexCount = bounded((long) vertexCount + count - fewerVertices);
        return count;
    }

    /** Codes how many faces or vertices are missing from what the splits would bring; components may bring more. */
    private int codeMissing(int statistics, int count) {
        return hasComponents ? faces.signed(coder, statistics, count) : faces.unsigned(coder, statistics, count);
    }

    private void completeRow() {
        rows.after(faceCount, vertexCount, ErrorScale.value(step))
                .in(level, pass)
                .precise(shift, precision(extentBits, coarsest))
                .bounded(step == ErrorScale.ZERO ? 0 : ErrorScale.value(2 * bound));
    }

    private MalformedStreamException malformed(String what) {
        return new MalformedStreamException(-1, "batch " + row + " " + what);
    }

    private static BatchKind kind(int number) throws MalformedStreamException {
        if (number >= KINDS.length) throw new MalformedStreamException(-1, "a batch of the unknown kind " + number);
        return KINDS[number];
    }

    private static int number(BatchKind kind) {
        int i = 0;
        while (KINDS[i] != kind) i++;
        return i;
    }

    /**
     * Tells to how many bits of the longest side the coarsest positions are known.
     *
     * @param extentBits of the longest side
     * @param coarsest shift of the coarsest position
     * @return the bits, or {@link #EXACT}
     */
    public static int precision(int extentBits, int coarsest) {
        return coarsest == 0 ? EXACT : Math.max(0, extentBits - coarsest);
    }

    /**
     * Tells the size that a batch exceeds by at most one split.
     *
     * @param offset of the byte that the batch starts at
     * @return bytes
     */
    public static int largest(long offset) {
        return (int) Math.min(1 << 16, Math.max(1 << 10, offset / 20));
    }

    /**
     * Tells the largest size of a batch.
     *
     * @param offset of the byte that the batch starts at
     * @return bytes
     */
    public static int cap(long offset) {
        return (int) Math.min(1 << 16, Math.max(Math.min(1 << 10, Math.max(100, offset / 3)), offset / 20));
    }

    private static int bounded(long count) throws MalformedStreamException {
        if (count < 0 || count > Integer.MAX_VALUE / 8)
            throw new MalformedStreamException(-1, "a count of the index is " + count);
        return (int) count;
    }
}
