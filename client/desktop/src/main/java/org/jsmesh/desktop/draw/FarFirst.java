package org.jsmesh.desktop.draw;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.jsmesh.display.RenderMesh;

/**
 * The order in which translucent faces are drawn, so that each shows those behind it: groups by the depth of their
 * middle, and the faces of a group by the depth of theirs, the farthest first. Faces of two groups that go through one
 * another may still be in the wrong order.
 */
final class FarFirst {
    private static final int STEPS = 1 << 16;

    private final RenderMesh mesh;
    private final float[] depths;
    private float nearest;
    private float farthest;

    /** @param view matrix from unit space to eye space, column by column */
    FarFirst(RenderMesh mesh, double[] view) {
        this.mesh = mesh;
        depths = new float[mesh.vertices()];
        float[] p = mesh.positions();
        nearest = Float.NEGATIVE_INFINITY;
        farthest = Float.POSITIVE_INFINITY;
        for (int i = 0; i < depths.length; i++) {
            depths[i] = (float) (view[2] * p[3 * i] + view[6] * p[3 * i + 1] + view[10] * p[3 * i + 2]);
            nearest = Math.max(nearest, depths[i]);
            farthest = Math.min(farthest, depths[i]);
        }
    }

    /**
     * @param groups positions in {@link RenderMesh#groups}
     * @return the same in the order to draw them in
     */
    List<Integer> groups(List<Integer> groups) {
        List<Integer> sorted = new ArrayList<>(groups);
        double[] middles = new double[mesh.groups().length];
        for (int g : groups) middles[g] = middle(mesh.groups()[g + 1], mesh.groups()[g + 2]);
        sorted.sort(Comparator.comparingDouble(g -> middles[g]));
        return sorted;
    }

    private double middle(int first, int count) {
        double sum = 0;
        for (int i = first; i < first + count; i++) sum += depths[mesh.indices()[i]];
        return sum / count;
    }

    /** The indices of a group in the order to draw them in: a counting sort, as it is needed for each picture. */
    int[] faces(int first, int count) {
        int[] steps = new int[count / 3];
        int[] starts = new int[STEPS + 1];
        for (int f = 0; f < steps.length; f++) {
            steps[f] = step(first + 3 * f);
            starts[steps[f] + 1]++;
        }
        Arrays.parallelPrefix(starts, Integer::sum);
        int[] sorted = new int[count];
        for (int f = 0; f < steps.length; f++)
            System.arraycopy(mesh.indices(), first + 3 * f, sorted, 3 * starts[steps[f]]++, 3);
        return sorted;
    }

    private int step(int index) {
        int[] of = mesh.indices();
        double depth = ((double) depths[of[index]] + depths[of[index + 1]] + depths[of[index + 2]]) / 3;
        double range = Math.max(1e-9, (double) nearest - farthest);
        return (int) Math.max(0, Math.min(STEPS - 1, (depth - farthest) / range * STEPS));
    }
}
