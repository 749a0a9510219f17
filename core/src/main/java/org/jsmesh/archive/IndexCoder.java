package org.jsmesh.archive;

import org.jsmesh.codec.BinaryCoder;
import org.jsmesh.codec.IntegerModel;
import org.jsmesh.mesh.MalformedStreamException;

/** Codes the batch index, each row as its difference from what the rows before it lead to expect; in both directions. */
final class IndexCoder {
    private static final int MAX_BATCHES = 1 << 24;
    private static final int MAX_SHIFT = 28;
    private static final int EXACT = 32;
    private final BinaryCoder coder;
    private final boolean write;
    private static final int KIND = 1;
    private static final int NEW_PASS = 2;
    private static final int DROP = 3;
    private static final BatchKind[] KINDS = {
        BatchKind.SPLITS, BatchKind.TEXTURE, BatchKind.PRECISION, BatchKind.ATTRIBUTES, BatchKind.ORDER
    };
    private final IntegerModel flags = new IntegerModel(4);
    private final IntegerModel bytes = new IntegerModel(6);
    private final IntegerModel patches = new IntegerModel(3);
    private final IntegerModel faces = new IntegerModel(2);
    private final IntegerModel errors = new IntegerModel(2);
    private BatchIndex source;

    IndexCoder(BinaryCoder coder) {
        this.coder = coder;
        write = coder.isEncoder();
    }

    /**
     * @param headBytes bytes in front of the base payload: known to the decoder alone
     * @param baseBytes bytes of the base payload with its checksum
     * @param extentBits bits of the longest side of the bounding box in cells
     */
    BatchIndex code(BatchIndex index, int headBytes, int baseBytes, int extentBits) throws MalformedStreamException {
        source = index;
        BatchIndexBuilder rows = new BatchIndexBuilder();
        int n = flags.unsigned(coder, write ? index.size() : 0);
        if (n < 1 || n > MAX_BATCHES) throw new MalformedStreamException(-1, n + " batches");
        int faceCount = bounded(faces.unsigned(coder, write ? index.faces(0) : 0));
        int vertexCount = bounded(faces.unsigned(coder, write ? index.vertices(0) : 0));
        int step = errors.unsigned(coder, write ? ErrorScale.step(index.errorMean(0)) : 0);
        int shift = flags.unsigned(coder, DROP, write ? index.shift(0) : 0);
        if (shift > MAX_SHIFT) throw new MalformedStreamException(-1, "positions in units of 2^" + shift);
        int coarsest = shift;
        int refined = 0;
        boolean attributes = false;
        rows.add(BatchKind.BASE, headBytes + baseBytes, 0)
                .after(faceCount, vertexCount, error(step))
                .precise(shift, precision(extentBits, coarsest));
        int level = 0;
        int pass = 0;
        long end = baseBytes;
        double bytesPerPatch = 4;
        for (int i = 1; i < n; i++) {
            if (coder.isExhausted()) throw new MalformedStreamException(-1, "the index ends early");
            BatchKind kind = kind(flags.unsigned(coder, KIND, write ? number(index.kind(i)) : 0));
            boolean splits = kind == BatchKind.SPLITS;
            int newPass = splits ? flags.unsigned(coder, NEW_PASS, write ? newPass(i, pass, level) : 0) : 0;
            if (newPass > 0) pass++;
            if (newPass > 1) level++;
            int cap = cap(end);
            int statistics = kind == BatchKind.TEXTURE || kind == BatchKind.ORDER
                    ? 3
                    : kind == BatchKind.ATTRIBUTES ? 5 : !splits ? 4 : newPass > 0 ? 1 : 2;
            int size = cap - bytes.signed(coder, statistics, write ? cap - index.bytes(i) : 0);
            if (size <= ArchiveLayout.CRC_BYTES || size > 1 << 20)
                throw new MalformedStreamException(-1, "batch " + i + " of " + size + " bytes");
            end += size;
            int patchCount = 0;
            if (attributes && (splits || kind == BatchKind.PRECISION))
                throw new MalformedStreamException(-1, "batch " + i + " comes after exact attributes");
            if (kind == BatchKind.ATTRIBUTES) {
                attributes = true;
                patchCount = bounded(patches.unsigned(coder, 2, write ? index.patches(i) : 0));
                if (coarsest > 0 || refined > 0)
                    throw new MalformedStreamException(-1, "batch " + i + " comes before exact positions");
            } else if (kind == BatchKind.PRECISION) {
                int drop = flags.unsigned(coder, DROP, write ? shift - index.shift(i) : 0);
                patchCount = bounded(patches.unsigned(coder, 1, write ? index.patches(i) : 0));
                boolean begins = refined == 0;
                refined += patchCount;
                if (drop > shift || begins != drop > 0 || refined > vertexCount)
                    throw new MalformedStreamException(-1, "batch " + i + " refines what is not there");
                shift -= drop;
                if (refined == vertexCount) {
                    refined = 0;
                    coarsest = shift;
                }
            } else if (splits) {
                if (refined > 0) throw new MalformedStreamException(-1, "batch " + i + " splits amid a sweep");
                int expected = (int) Math.min(1 << 24, size / bytesPerPatch);
                patchCount = bounded(expected + patches.signed(coder, 0, write ? index.patches(i) - expected : 0));
                if (patchCount > 0) bytesPerPatch = size / (double) patchCount;
                int fewer =
                        faces.unsigned(coder, 1, write ? 2 * patchCount - (index.faces(i) - index.faces(i - 1)) : 0);
                faceCount = bounded((long) faceCount + 2L * patchCount - fewer);
                vertexCount = bounded((long) vertexCount + patchCount);
            }
            step += errors.signed(coder, 1, write ? ErrorScale.step(index.errorMean(i)) - step : 0);
            rows.add(kind, size, patchCount)
                    .after(faceCount, vertexCount, error(step))
                    .in(level, pass)
                    .precise(shift, precision(extentBits, coarsest));
        }
        if (coarsest > 0) throw new MalformedStreamException(-1, "the index ends before the positions are exact");
        return rows.build();
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

    /** Bits of the longest side, by which the coarsest positions are known. */
    static int precision(int extentBits, int coarsest) {
        return coarsest == 0 ? EXACT : Math.max(0, extentBits - coarsest);
    }

    private int newPass(int batch, int pass, int level) {
        return source.level(batch) > level ? 2 : source.pass(batch) > pass ? 1 : 0;
    }

    /** The largest size of a batch that starts at an offset. */
    static int cap(long offset) {
        return (int) Math.min(1 << 16, Math.max(1 << 10, offset / 20));
    }

    private static int bounded(long count) throws MalformedStreamException {
        if (count < 0 || count > Integer.MAX_VALUE / 8)
            throw new MalformedStreamException(-1, "a count of the index is " + count);
        return (int) count;
    }

    private static double error(int step) throws MalformedStreamException {
        if (step < 0 || step > ErrorScale.ZERO)
            throw new MalformedStreamException(-1, "an error of the index is out of range");
        return ErrorScale.value(step);
    }
}
