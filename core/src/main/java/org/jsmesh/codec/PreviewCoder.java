package org.jsmesh.codec;

import java.util.function.BooleanSupplier;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * Codes a small picture of an image in stages, each with twice the width and height of the one before. Colours are luma
 * and two differences (YCoCg-R, Malvar and Sullivan 2003), in steps that each stage has of its own. A stage comes in
 * portions of rows, and is shown when its last row is there.
 */
public final class PreviewCoder {
    /** A picture has at most so many columns and rows. */
    public static final int LARGEST = 512;
    /** The first stage has at most so many columns and rows. */
    public static final int LARGEST_FIRST = 16;

    private static final int SIDE_BITS = 4;
    private static final int STEP_BITS = 5;
    private final PreviewModel model;
    private PreviewStage shown; // or null
    private PreviewStage coming; // or null
    private int rows; // of the coming stage; of a later stage pairs

    /**
     * What an encoder wants a stage to show.
     *
     * @param width columns; from the second stage on twice those of the stage before
     * @param height likewise
     * @param step of luma, 1 to 32; of the differences it is half as much again
     * @param alpha whether opacity is coded; as in the first stage
     * @param argb alpha, red, green, blue per pixel of the stage, row by row from the top
     * @param free pixels that may have any colour
     */
    public record Wanted(int width, int height, int step, boolean alpha, int[] argb, boolean[] free) {}

    /** @param model that all previews of an archive share */
    public PreviewCoder(PreviewModel model) {
        this.model = model;
    }

    /** Width of the last stage that is whole, 0 before the first. */
    public int width() {
        return shown == null ? 0 : shown.width;
    }

    /** Height of the last stage that is whole. */
    public int height() {
        return shown == null ? 0 : shown.height;
    }

    /** Alpha, red, green, blue of the last stage that is whole, row by row from the top. */
    public int[] argb() {
        return shown.argb();
    }

    /** Is there a stage that has begun and is not whole? */
    public boolean isAmidStage() {
        return coming != null;
    }

    /** Pixels that there will be with the stage under way, or that the next one will have. */
    public int pixels() {
        if (coming != null) return coming.width * coming.height;
        return shown == null ? LARGEST_FIRST * LARGEST_FIRST : 4 * shown.width * shown.height;
    }

    /**
     * Codes rows of the stage under way, or of the next one.
     *
     * @param wanted of the stage; null for a decoder
     * @param isFull asks, for an encoder, whether the batch is to end after the rows so far
     * @throws MalformedStreamException when the picture becomes too large, or the bytes end early
     */
    public void codePortion(BinaryCoder coder, Wanted wanted, BooleanSupplier isFull) throws MalformedStreamException {
        if (coming == null) begin(coder, wanted);
        int all = shown == null ? coming.height : shown.height;
        boolean isMore = true;
        while (isMore) {
            if (shown == null) coming.codeRow(coder, rows, wanted);
            else coming.codeRows(coder, rows, shown, wanted);
            if (coder.isExhausted()) throw new MalformedStreamException(-1, "a preview ends early");
            if (++rows == all) {
                shown = coming;
                coming = null;
                return;
            }
            isMore = model.codeMore(coder, wanted != null && !isFull.getAsBoolean());
        }
    }

    private void begin(BinaryCoder coder, Wanted wanted) throws MalformedStreamException {
        rows = 0;
        boolean isFirst = shown == null;
        int width = isFirst ? 1 + coder.raw(wanted == null ? 0 : wanted.width - 1, SIDE_BITS) : 2 * shown.width;
        int height = isFirst ? 1 + coder.raw(wanted == null ? 0 : wanted.height - 1, SIDE_BITS) : 2 * shown.height;
        if (Math.max(width, height) > LARGEST)
            throw new MalformedStreamException(-1, "a preview of more than " + LARGEST + " pixels");
        int alpha = isFirst ? coder.raw(wanted != null && wanted.alpha ? 1 : 0, 1) : 0;
        int planes = isFirst ? PreviewStage.ALPHA + alpha : shown.planeCount;
        int step = 1 + coder.raw(wanted == null ? 0 : wanted.step - 1, STEP_BITS);
        coming = new PreviewStage(model, isFirst, width, height, planes, step);
    }
}
