package org.jsmesh.encode;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.codec.PreviewCoder;
import org.jsmesh.codec.PreviewModel;
import org.jsmesh.codec.entropy.RangeEncoder;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * Chooses the stages of an image's preview, and how finely each shows its colours. A step of a stage costs as many bits
 * as half of it in the stage before, and does as much, so each stage has twice the step of the one before. Tries such
 * ladders from coarse to fine, and where each may end.
 */
final class PreviewLadder {
    private static final int FIRST_SIDE = 8; // pixels of the longer side of the first stage
    private static final int COARSEST = 32; // step
    /** Steps of luma at 512 pixels; larger ones make the stages before it coarser. */
    private static final int[] STEPS = {
        256, 181, 128, 91, 64, 54, 45, 40, 36, 32, 27, 23, 19, 16, 14, 12, 11, 10, 9, 8, 6
    };
    /** Ladders beyond the best one that are tried. */
    private static final int PATIENCE = 3;
    /** A preview takes at most this share of its image's bytes, in addition to them. */
    private static final double MOST_BYTES = .03;
    /** The same where it brings the colours close enough to the image's. */
    private static final double MOST_BYTES_TO_GOAL = .12;
    /** A byte of a preview counts as so many of the image. */
    private static final double WEIGHT = 2;

    private final PaintedImage painted;
    private final int mostPixels;
    private final double imageBytes;
    private final double goal;
    private Choice best;
    private double closest;

    /** A stage that was tried. */
    record Tried(PreviewCoder.Wanted stage, int bytes, double off) {}

    /**
     * A ladder of stages.
     *
     * @param reach stages after which the goal is reached, or 0
     * @param toGoal bytes of these
     * @param cost how far off the colours are while preview and image arrive, times bytes
     */
    private record Choice(List<Tried> stages, int reach, int toGoal, double cost) {}

    /**
     * @param mostPixels of a preview
     * @param goal difference from the image that is close enough, in % of white over all of the surface
     */
    PreviewLadder(PaintedImage painted, int mostPixels, double imageBytes, double goal) {
        this.painted = painted;
        this.mostPixels = mostPixels;
        this.imageBytes = imageBytes;
        this.goal = goal;
    }

    /**
     * The stages to send. They bring the colours as close as the goal if they can, and if they cannot do so with few
     * bytes, with the fewest bytes. The last one brings them closer than all others.
     */
    List<Tried> best() throws MalformedStreamException {
        int longer = Math.max(painted.width(), painted.height());
        int width = Math.max(1, Math.round((float) FIRST_SIDE * painted.width() / longer));
        int height = Math.max(1, Math.round((float) FIRST_SIDE * painted.height() / longer));
        int count = 0;
        while (isRightFor(width << count, height << count)) count++;
        double plain = painted.differenceFromPlain();
        best = new Choice(List.of(), 0, 0, plain * imageBytes);
        if (count == 0) return best.stages;
        climb(painted.rasters(width, height, count, false), plain);
        if (goal > 0 && best.reach == 0) climb(painted.rasters(width, height, count, true), plain);
        return best.stages;
    }

    private void climb(List<PreviewRaster> rasters, double plain) throws MalformedStreamException {
        closest = plain;
        int worse = 0;
        for (int k = 0; k < STEPS.length && worse < PATIENCE; k++) {
            Choice before = best;
            double closestBefore = closest;
            List<Tried> tried = tryStages(rasters, STEPS[k]);
            for (int n = 1; n <= tried.size(); n++) compare(tried.subList(0, n), plain);
            boolean mayReach = best.reach == 0 && closest < closestBefore;
            worse = best == before && !mayReach ? worse + 1 : 0;
        }
    }

    /** @param last step of luma at 512 pixels */
    private static int step(int stage, int last) {
        int bits = Integer.numberOfTrailingZeros(PreviewCoder.LARGEST / FIRST_SIDE);
        return Math.max(1, Math.min(COARSEST, ((last << stage) + (1 << bits - 1)) >> bits));
    }

    private boolean isRightFor(int width, int height) {
        return width <= painted.width()
                && height <= painted.height()
                && width * height <= mostPixels
                && Math.max(width, height) <= PreviewCoder.LARGEST;
    }

    private List<Tried> tryStages(List<PreviewRaster> rasters, int last) throws MalformedStreamException {
        List<Tried> tried = new ArrayList<>();
        PreviewCoder coder = new PreviewCoder(new PreviewModel());
        double bytes = 0;
        for (int i = 0; i < rasters.size(); i++) {
            PreviewCoder.Wanted stage = rasters.get(i).wanted(step(i, last), painted.hasAlpha());
            RangeEncoder stream = new RangeEncoder();
            coder.codePortion(stream, stage, () -> false);
            int size = stream.finish().length;
            bytes += size;
            if (bytes > mostBytes()) break;
            tried.add(new Tried(stage, size, painted.differenceFrom(coder.argb(), stage.width(), stage.height())));
        }
        return tried;
    }

    /** Bytes of a preview that may still be the best one. */
    private double mostBytes() {
        double few = MOST_BYTES * imageBytes;
        if (best.reach > 0) return Math.max(few, best.toGoal);
        return goal > 0 ? MOST_BYTES_TO_GOAL * imageBytes : few;
    }

    private void compare(List<Tried> stages, double plain) {
        int bytes = 0;
        int reach = 0;
        int toGoal = 0;
        double cost = 0;
        double off = plain;
        for (int i = 0; i < stages.size(); i++) {
            cost += WEIGHT * stages.get(i).bytes() * off;
            bytes += stages.get(i).bytes();
            off = stages.get(i).off();
            if (off > goal || reach > 0) continue;
            reach = i + 1;
            toGoal = bytes;
        }
        Choice choice = new Choice(stages, reach, toGoal, cost + off * imageBytes);
        closest = Math.min(closest, off);
        boolean isSmall = bytes <= MOST_BYTES * imageBytes;
        if (!isSmall && reach < stages.size()) return; // it is not close, or closer than it need be
        if (isBetter(choice, isSmall)) best = choice;
    }

    private boolean isBetter(Choice choice, boolean isSmall) {
        boolean isBestSmall = best.toGoal <= MOST_BYTES * imageBytes;
        if (choice.reach > 0 != best.reach > 0) return choice.reach > 0;
        if (choice.reach == 0 || isSmall && isBestSmall) return choice.cost < best.cost;
        return choice.toGoal < best.toGoal;
    }
}
