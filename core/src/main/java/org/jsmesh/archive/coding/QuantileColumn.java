package org.jsmesh.archive.coding;

import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.BatchIndexBuilder;
import org.jsmesh.archive.BatchKind;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.IntegerModel;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * Codes the quantiles of the errors in both directions, behind all rows of the index: the opening does not need them.
 * They are steps of 1/8 as the bounds are, between bound and mean, and do not rise. Where splits come, a quantile is
 * expected to fall as the mean does; else it is expected to stay, because the last coarse vertices hold it up.
 */
final class QuantileColumn {
    private static final int BASE = 0;
    private static final int SPLITS = 1;
    private static final int OTHERS = 2;

    /** Half steps from the mean to the quantile of a base, mostly. */
    private static final int TYPICAL = 16;

    private final BatchIndex source;
    private final BatchIndexBuilder rows;
    private final IntegerModel steps = new IntegerModel(3);

    /**
     * @param source the index without the row of the batch that ends the header; null for a decoder
     * @param rows whose quantiles are to be set; a decoder has all of them, an encoder all but that one
     */
    QuantileColumn(BatchIndex source, BatchIndexBuilder rows) {
        this.source = source;
        this.rows = rows;
    }

    void code(BinaryCoder coder) throws MalformedStreamException {
        BatchIndex index = rows.build();
        int of = 0; // row of the source
        int last = 0; // half steps of the mean
        int now = 0; // half steps of the quantile
        for (int i = 0; i < index.size(); i++) {
            BatchKind kind = index.kind(i);
            int mean = ErrorScale.step(index.errorMean(i)) / 2;
            if (kind != BatchKind.HEADER && index.errorMean(i) > 0) {
                int most = Math.max(now, mean);
                int least = Math.max(now, Math.min(most, ErrorScale.step(index.errorBound(i)) / 2));
                int guess = kind == BatchKind.SPLITS ? now + mean - last : i == 0 ? mean - TYPICAL : now;
                int expected = Math.max(least, Math.min(most, guess));
                int statistics = i == 0 ? BASE : kind == BatchKind.SPLITS ? SPLITS : OTHERS;
                now = expected + steps.signed(coder, statistics, source == null ? 0 : half(of) - expected);
                if (now < least || now > most)
                    throw new MalformedStreamException(-1, "batch " + i + " has an error's quantile out of range");
            }
            last = mean;
            if (kind != BatchKind.HEADER) of++;
            rows.quantile(i, index.errorMean(i) > 0 ? ErrorScale.value(2 * now) : 0);
        }
    }

    private int half(int row) {
        return ErrorScale.step(source.errorQuantile(row)) / 2;
    }
}
