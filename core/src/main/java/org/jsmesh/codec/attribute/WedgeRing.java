package org.jsmesh.codec.attribute;

import java.util.Arrays;
import org.jsmesh.codec.lattice.Translation;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.mesh.CornerTable;

/**
 * Predicts the values of a wedge from the faces around it. The place of its vertex among its neighbours on the exact
 * mesh tells the place of its values among theirs. Inside a chart the prediction uses mean value coordinates (Floater
 * 2003) and the faces beyond, at the rim of a chart the latter alone.
 */
final class WedgeRing {
    /**
     * Share of the faces beyond. The mean alone errs by the curvature of the map; the faces beyond err by twice that,
     * the other way.
     */
    private static final double BEYOND = .4;

    /** A face beyond that is much flatter than the one before it says little. */
    private static final double MOST_STRETCH = 4;

    /** Weight of a face of exact values, in others. */
    private static final double EXACT = 64;

    private final LodMesh mesh;
    private final Translation translation;
    private final int[] corner; // the first corner of each wedge's faces, or one of them
    private final double[] at = new double[3]; // of the vertex
    private final double[] inner = new double[4];
    private final double[] beyond = new double[4];
    private final double[] mean = new double[4];
    private final double[] u = new double[3];
    private final double[] v = new double[3];
    private final double[] w = new double[3];
    private final double[] edge = new double[3];
    private double innerWeight;
    private double beyondWeight;
    private int meanCount;
    private boolean open;

    /** The prediction of the channel last asked for. */
    final double[] predicted = new double[4];

    WedgeRing(LodMesh mesh, Translation translation) {
        this.mesh = mesh;
        this.translation = translation;
        corner = new int[mesh.wedges()];
        Arrays.fill(corner, -1);
        CornerTable t = mesh.table();
        for (int f = 0; f < t.faces(); f++) {
            if (t.isDummy(f)) continue;
            for (int c = CornerTable.STRIDE * f; c < CornerTable.STRIDE * f + 3; c++) {
                int wedge = mesh.wedge(c);
                if (corner[wedge] < 0 || !continues(t.swingBack(c), wedge)) corner[wedge] = c;
            }
        }
    }

    private boolean continues(int c, int wedge) {
        return !mesh.table().isDummy(CornerTable.face(c)) && mesh.wedge(c) == wedge;
    }

    /** The first corner of a wedge's faces, or one of them; −1 when there is none. */
    int corner(int wedge) {
        return corner[wedge];
    }

    /** The mean of the known numbers of the wedges around, which are not negative, and of one more number. */
    double meanOf(double[] numbers, int wedge, double sum) {
        double all = sum;
        int n = 1;
        int c = corner[wedge];
        if (c < 0) return sum;
        do {
            double a = numbers[mesh.wedge(CornerTable.next(c))];
            double b = numbers[mesh.wedge(CornerTable.previous(c))];
            if (a >= 0) {
                all += a;
                n++;
            }
            if (b >= 0) {
                all += b;
                n++;
            }
            c = mesh.table().swing(c);
        } while (c != corner[wedge] && continues(c, wedge));
        return all / n;
    }

    /**
     * Computes the mean of the shown values of the neighbours, when the wedge is the only one of its vertex and all of
     * them are exact.
     */
    boolean interpolate(int wedge, ChannelValues values, double[] mean) {
        int start = corner[wedge];
        if (start < 0) return false;
        Arrays.fill(mean, 0);
        int n = 0;
        int c = start;
        do {
            if (!continues(c, wedge)) return false;
            int other = mesh.wedge(CornerTable.next(c));
            if (other != mesh.wedge(CornerTable.previous(mesh.table().swingBack(c)))) return false;
            if (!values.refined.get(other) || values.absent.get(other)) return false;
            for (int k = 0; k < values.components; k++) mean[k] += Float.intBitsToFloat(values.value(other, k));
            n++;
            c = mesh.table().swing(c);
        } while (c != start);
        for (int k = 0; k < values.components; k++) mean[k] /= n;
        return true;
    }

    /** Predicts a channel's cells at a wedge from those of the wedges around it. False when there are none. */
    boolean predict(int wedge, ChannelValues values) {
        int start = corner[wedge];
        if (start < 0) return false;
        CornerTable t = mesh.table();
        Arrays.fill(inner, 0);
        Arrays.fill(beyond, 0);
        Arrays.fill(mean, 0);
        innerWeight = 0;
        beyondWeight = 0;
        meanCount = 0;
        locate(t.vertex(start), at);
        int c = start;
        open = false;
        do {
            addFace(c, values);
            c = t.swing(c);
            open = !continues(c, wedge);
        } while (!open && c != start);
        if (meanCount == 0) return false;
        for (int k = 0; k < values.components; k++) {
            double far = beyondWeight == 0 ? 0 : beyond[k] / beyondWeight;
            double near = innerWeight == 0 ? mean[k] / meanCount : inner[k] / innerWeight;
            if (open) predicted[k] = beyondWeight == 0 ? mean[k] / meanCount : far;
            else if (beyondWeight == 0) predicted[k] = near;
            else predicted[k] = near * (1 - BEYOND) + far * BEYOND;
        }
        return true;
    }

    /** Does the wedge last predicted lie at the rim of its chart? */
    boolean isOpen() {
        return open;
    }

    private void addFace(int c, ChannelValues values) {
        CornerTable t = mesh.table();
        int next = CornerTable.next(c);
        int previous = CornerTable.previous(c);
        int a = mesh.wedge(next);
        int b = mesh.wedge(previous);
        if (values.absent.get(a) || values.absent.get(b)) return;
        for (int k = 0; k < values.components; k++) mean[k] = mean[k] + values.cell(a, k) + values.cell(b, k);
        meanCount += 2;
        direction(t.vertex(next), at, u);
        direction(t.vertex(previous), at, v);
        double uLength = Math.sqrt(dot(u, u));
        double vLength = Math.sqrt(dot(v, v));
        if (uLength == 0 || vLength == 0) return;
        double cross = cross(u, v);
        double below = dot(u, v) + uLength * vLength;
        if (below <= 0) return;
        double tangent = cross / below; // of half the angle
        double toA = tangent / uLength;
        double toB = tangent / vLength;
        for (int k = 0; k < values.components; k++)
            inner[k] = inner[k] + toA * values.cell(a, k) + toB * values.cell(b, k);
        innerWeight = innerWeight + toA + toB;
        addBeyond(next, previous, a, b, cross, values);
    }

    /** Adds the face behind a→b, unfolded and continued as an affine map to the vertex. */
    private void addBeyond(int next, int previous, int a, int b, double cross, ChannelValues values) {
        CornerTable t = mesh.table();
        int behind = t.swing(previous); // corner at b there
        if (!continues(behind, b) || mesh.wedge(CornerTable.next(behind)) != a) return;
        int tip = CornerTable.previous(behind);
        int other = mesh.wedge(tip);
        if (values.absent.get(other)) return;
        for (int i = 0; i < 3; i++) edge[i] = v[i] - u[i];
        double square = dot(edge, edge);
        if (square == 0) return;
        locate(t.vertex(tip), w);
        for (int i = 0; i < 3; i++) w[i] = w[i] - at[i] - u[i]; // from a
        double depth = cross(edge, w);
        if (depth == 0) return;
        double along = -dot(u, edge) / square;
        double alongTip = dot(w, edge) / square;
        boolean exact = values.refined.get(a) && values.refined.get(b) && values.refined.get(other);
        double weight = exact ? EXACT : 1;
        double stretch = Math.min(MOST_STRETCH, cross / depth);
        for (int k = 0; k < values.components; k++) {
            double from = values.cell(a, k);
            double step = values.cell(b, k) - from;
            double aside = values.cell(other, k) - from - alongTip * step;
            double x = from + along * step - stretch * aside;
            beyond[k] += x * weight;
        }
        beyondWeight += weight;
    }

    private void direction(int fan, double[] from, double[] to) {
        locate(fan, to);
        for (int i = 0; i < 3; i++) to[i] -= from[i];
    }

    private void locate(int fan, double[] to) {
        int vertex = 3 * mesh.vertexOf(fan);
        for (int i = 0; i < 3; i++) to[i] = Float.intBitsToFloat(translation.moved(i, mesh.positionBits()[vertex + i]));
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    private static double cross(double[] a, double[] b) {
        double x = a[1] * b[2] - a[2] * b[1];
        double y = a[2] * b[0] - a[0] * b[2];
        double z = a[0] * b[1] - a[1] * b[0];
        return Math.sqrt(x * x + y * y + z * z);
    }
}
