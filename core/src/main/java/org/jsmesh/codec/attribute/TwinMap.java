package org.jsmesh.codec.attribute;

import java.util.Arrays;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.codec.position.WedgeTwins;
import org.jsmesh.mesh.CornerTable;

/**
 * Predicts pairs of values, such as texture coordinates, from those of the mirror image. A least-squares fit over the
 * wedges around gives the affine map from the one to the other. The map changes little from one wedge to the next, so
 * the last map stands in for what the wedges around leave open.
 */
final class TwinMap {
    /** Weight of the last map, in exact wedges. */
    private static final double INERTIA = .02;

    private final LodMesh mesh;
    private final WedgeTwins twins;
    private final ChannelValues values;
    private final double[] map = {1, 0, 0, 1};
    private final double[] sums = new double[10];
    private int[] met = new int[64];
    private int meets;
    private double exact; // weight of an exact wedge
    final double[] predicted = new double[2];

    TwinMap(LodMesh mesh, WedgeTwins twins, ChannelValues values) {
        this.mesh = mesh;
        this.twins = twins;
        this.values = values;
    }

    /**
     * Predicts the cells of a wedge. Returns false when its image has no exact values yet, or no wedge around it has an
     * image.
     *
     * @param corner one of the wedge's
     * @param error to be expected, in cells: the smaller it is, the more exact wedges outweigh the others
     */
    boolean predict(int wedge, int corner, double error) {
        int twin = twins.of(wedge);
        if (corner < 0 || twin < 0 || !isExact(twin)) return false;
        double noise = 1 << values.format.shift();
        exact = Math.max(1, noise * noise / (error * error + 1));
        meets = 0;
        Arrays.fill(sums, 0);
        CornerTable t = mesh.table();
        int c = corner;
        do {
            if (!continues(c, wedge)) break;
            int next = CornerTable.next(c);
            int previous = CornerTable.previous(c);
            meet(mesh.wedge(next));
            meet(mesh.wedge(previous));
            int behind = t.swing(previous);
            if (continues(behind, mesh.wedge(previous)) && mesh.wedge(CornerTable.next(behind)) == mesh.wedge(next))
                meet(mesh.wedge(CornerTable.previous(behind)));
            c = t.swing(c);
        } while (c != corner);
        if (sums[0] == 0) return false;
        fit();
        double x = values.cell(twin, 0) - sums[1] / sums[0];
        double y = values.cell(twin, 1) - sums[2] / sums[0];
        for (int k = 0; k < 2; k++) predicted[k] = sums[3 + k] / sums[0] + map[2 * k] * x + map[2 * k + 1] * y;
        return true;
    }

    private boolean isExact(int wedge) {
        return values.refined.get(wedge) && !values.absent.get(wedge);
    }

    private boolean continues(int c, int wedge) {
        return !mesh.table().isDummy(CornerTable.face(c)) && mesh.wedge(c) == wedge;
    }

    private void meet(int wedge) {
        int twin = twins.of(wedge);
        if (twin < 0 || !isExact(twin) || values.absent.get(wedge)) return;
        for (int i = 0; i < meets; i++) if (met[i] == wedge) return;
        if (meets == met.length) met = Arrays.copyOf(met, 2 * meets);
        met[meets++] = wedge;
        double weight = values.refined.get(wedge) ? exact : 1;
        sums[0] += weight;
        for (int k = 0; k < 2; k++) {
            sums[1 + k] += weight * values.cell(twin, k);
            sums[3 + k] += weight * values.cell(wedge, k);
        }
    }

    /** Brings the map up to date. */
    private void fit() {
        double meanX = sums[1] / sums[0];
        double meanY = sums[2] / sums[0];
        double xx = 0;
        double xy = 0;
        double yy = 0;
        double[] off = sums; // of both components, times x and y: places 5 to 8
        for (int i = 0; i < meets; i++) {
            double weight = values.refined.get(met[i]) ? exact : 1;
            int twin = twins.of(met[i]);
            double x = values.cell(twin, 0) - meanX;
            double y = values.cell(twin, 1) - meanY;
            xx += weight * x * x;
            xy += weight * x * y;
            yy += weight * y * y;
            for (int k = 0; k < 2; k++) {
                double d = values.cell(met[i], k) - sums[3 + k] / sums[0] - map[2 * k] * x - map[2 * k + 1] * y;
                off[5 + 2 * k] += weight * d * x;
                off[6 + 2 * k] += weight * d * y;
            }
        }
        double inertia = INERTIA * (xx + yy) + 1;
        xx += inertia;
        yy += inertia;
        double determinant = xx * yy - xy * xy;
        if (determinant <= 0) return;
        for (int k = 0; k < 2; k++) {
            map[2 * k] += (off[5 + 2 * k] * yy - off[6 + 2 * k] * xy) / determinant;
            map[2 * k + 1] += (off[6 + 2 * k] * xx - off[5 + 2 * k] * xy) / determinant;
        }
    }
}
