package org.jsmesh.codec;

import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.IntegerModel;

/** The statistics that the previews of all images of an archive share. */
public final class PreviewModel {
    /** Details per pixel of the stage before: across, down, both. */
    static final int DETAILS = 3;

    private static final int PLANES = 4;
    /** Of a plane: the details, then the values of a first stage. */
    private static final int KINDS = DETAILS + 1;

    private static final int NEIGHBOURS = 8;
    private static final int ROUGH = 7;
    private static final int LEVELS = 3; // 0, 1, more
    private static final int SIGNS = 3;

    private final int[] byNeighbours = BinaryCoder.newContexts(PLANES * KINDS * NEIGHBOURS * ROUGH);
    private final int[] byScale = BinaryCoder.newContexts(PLANES * KINDS * ROUGH * LEVELS * LEVELS * LEVELS);
    private final int[] negative = BinaryCoder.newContexts(PLANES * KINDS * SIGNS * SIGNS);
    private final IntegerModel beyondOne = new IntegerModel(PLANES * KINDS * NEIGHBOURS);
    private final int[] more = BinaryCoder.newContexts(1);

    /** What is known around a number, in steps. */
    static final class Around {
        /** Magnitudes of the numbers beside it, those to the left and above twice. */
        int neighbours;
        /** How much the stage before varies there, in quarters of a step. */
        int rough;
        /** Magnitude in the stage before. */
        int coarser;
        /** Magnitudes of the details before it, of the same four pixels. */
        int before;
        /** The same number of luma. */
        int luma;
        /** Of the neighbour that it is most like: −1, 0 or 1. */
        int sign;

        void clear() {
            neighbours = rough = coarser = before = luma = sign = 0;
        }
    }

    /** Codes whether another row follows in the batch. */
    boolean codeMore(BinaryCoder coder, boolean isMore) {
        return coder.bit(more, 0, isMore ? 1 : 0) != 0;
    }

    /** Codes a number of steps. */
    int code(BinaryCoder coder, int plane, int kind, Around around, int steps) {
        int set = plane * KINDS + kind;
        int n = around.neighbours;
        int near = set * NEIGHBOURS + (n < 3 ? n : Math.min(NEIGHBOURS - 1, 1 + bits(n + 1)));
        int rough = Math.min(ROUGH - 1, bits(around.rough));
        int luma = level(Math.abs(around.luma));
        int scale = ((set * ROUGH + rough) * LEVELS + level(around.coarser)) * LEVELS * LEVELS;
        scale += level(around.before) * LEVELS + luma;
        if (coder.bit(byNeighbours, near * ROUGH + rough, byScale, scale, steps != 0 ? 1 : 0) == 0) return 0;
        int signs = (set * SIGNS + around.sign + 1) * SIGNS + Integer.signum(around.luma) + 1;
        int sign = coder.bit(negative, signs, steps < 0 ? 1 : 0) != 0 ? -1 : 1;
        return sign * (1 + beyondOne.unsigned(coder, near, Math.abs(steps) - 1));
    }

    private static int level(int magnitude) {
        return Math.min(LEVELS - 1, magnitude);
    }

    private static int bits(int n) {
        return 32 - Integer.numberOfLeadingZeros(n);
    }
}
