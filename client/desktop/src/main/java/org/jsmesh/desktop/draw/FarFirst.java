package org.jsmesh.desktop.draw;

import java.util.Arrays;
import org.jsmesh.display.LiveStep;

/**
 * The order in which translucent faces are drawn, so that each shows those behind it: by the depth of their middle, the
 * farthest first, whatever their material. Where large faces lie close behind each other, or go through one another,
 * that is not the order of each of their points.
 */
final class FarFirst {
    private static final int STEPS = 1 << 16;

    private final int[] indices;
    private final float[] depths;

    /** Indices in the order to draw them in, and runs of them as {@code RenderMesh#groups} has groups. */
    record Order(int[] indices, int[] runs) {}

    /** @param view matrix from unit space to eye space, column by column */
    FarFirst(MeshArrays arrays, double[] view) {
        indices = arrays.bits(LiveStep.INDICES);
        depths = new float[arrays.vertices()];
        int[] p = arrays.bits(LiveStep.POSITIONS);
        for (int i = 0; i < depths.length; i++) {
            depths[i] = (float) (view[2] * Float.intBitsToFloat(p[3 * i])
                    + view[6] * Float.intBitsToFloat(p[3 * i + 1])
                    + view[10] * Float.intBitsToFloat(p[3 * i + 2]));
        }
    }

    /**
     * A counting sort, as it is needed for each picture. Faces at one depth stay in the order of the groups.
     *
     * @param groups three numbers each: slot, first index, number of indices
     */
    Order order(int[] groups) {
        int count = 0;
        for (int g = 0; g < groups.length; g += 3) count += groups[g + 2] / 3;
        int[] faces = new int[count];
        int[] slots = new int[count];
        double[] middles = new double[count];
        int n = 0;
        for (int g = 0; g < groups.length; g += 3) {
            for (int i = groups[g + 1]; i < groups[g + 1] + groups[g + 2]; i += 3, n++) {
                faces[n] = i;
                slots[n] = groups[g];
                middles[n] = ((double) depths[indices[i]] + depths[indices[i + 1]] + depths[indices[i + 2]]) / 3;
            }
        }
        int[] order = sorted(middles);
        int[] sorted = new int[3 * count];
        int[] runs = new int[3 * count];
        int end = 0;
        for (int i = 0; i < count; i++) {
            System.arraycopy(indices, faces[order[i]], sorted, 3 * i, 3);
            int slot = slots[order[i]];
            if (end == 0 || runs[end - 3] != slot) {
                runs[end++] = slot;
                runs[end++] = 3 * i;
                runs[end++] = 0;
            }
            runs[end - 1] += 3;
        }
        return new Order(sorted, Arrays.copyOf(runs, end));
    }

    private static int[] sorted(double[] middles) {
        double farthest = Double.POSITIVE_INFINITY;
        double nearest = Double.NEGATIVE_INFINITY;
        for (double depth : middles) {
            farthest = Math.min(farthest, depth);
            nearest = Math.max(nearest, depth);
        }
        double scale = (STEPS - 1) / Math.max(1e-9, nearest - farthest);
        int[] starts = new int[STEPS + 1];
        for (double depth : middles) starts[1 + (int) ((depth - farthest) * scale)]++;
        for (int i = 0; i < STEPS; i++) starts[i + 1] += starts[i];
        int[] order = new int[middles.length];
        for (int i = 0; i < middles.length; i++) order[starts[(int) ((middles[i] - farthest) * scale)]++] = i;
        return order;
    }
}
