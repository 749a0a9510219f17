package org.jsmesh.codec.attribute;

import java.util.Arrays;
import org.jsmesh.codec.lattice.Translation;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Sizes;

/**
 * Weighted sums of the normals of the faces that share a wedge, see {@link NormalFormula}; in doubles, with operations
 * that are the same on every machine.
 */
public final class NormalSums {
    /** Sums shorter than this part of their weights are rounding. */
    private static final double NOTHING = 1e-13;

    private static final double HALF_PI = 1.5707963267948966;
    private static final int ATAN_TERMS = 12;

    private final int weight;
    private final double[] sums; // four per wedge: x, y, z, sum of the weights
    private final double[] at = new double[9]; // coordinates of the face's corners

    NormalSums(int weight, int wedges) {
        this.weight = weight;
        sums = new double[Sizes.of(4, wedges, "corners with normals")];
    }

    /** The sums of the mesh as it is now. */
    static NormalSums of(LodMesh mesh, int weight, Translation translation) {
        NormalSums sums = new NormalSums(weight, mesh.wedges());
        CornerTable t = mesh.table();
        int[] bits = mesh.positionBits();
        for (int f = 0; f < t.faces(); f++) {
            if (t.isDummy(f)) continue;
            int c = CornerTable.STRIDE * f;
            for (int j = 0; j < 3; j++) {
                int v = 3 * mesh.vertexOf(t.vertex(c + j));
                for (int a = 0; a < 3; a++)
                    sums.at[3 * j + a] = Float.intBitsToFloat(translation.moved(a, bits[v + a]));
            }
            sums.add(mesh.wedge(c), mesh.wedge(c + 1), mesh.wedge(c + 2));
        }
        return sums;
    }

    /** Gives wedges whose normals are still to come the normals of the shown mesh. */
    public static void show(LodMesh mesh, Translation translation, ChannelValues values) {
        if (values.refined.cardinality() == mesh.wedges()) return;
        values.grow(mesh.wedges());
        NormalSums sums = of(mesh, values.format.normals().weight(), translation);
        for (int w = values.refined.nextClearBit(0); w < mesh.wedges(); w = values.refined.nextClearBit(w + 1)) {
            if (values.absent.get(w)) continue;
            double scale = sums.unitScale(w);
            for (int k = 0; k < 3; k++) values.set(w, k, 0, sums.shownBits(w, k, scale));
        }
    }

    /** The sum of a single wedge, which has the number 0. */
    public static NormalSums ofOne(int weight) {
        return new NormalSums(weight, 2);
    }

    /** Forgets all faces. */
    public void clear() {
        Arrays.fill(sums, 0);
    }

    /**
     * Adds a face to the sum of a single wedge.
     *
     * @param xyz coordinates of its corners
     * @param own bit j: corner j has the wedge
     */
    public void add(double[] xyz, int own) {
        System.arraycopy(xyz, 0, at, 0, at.length);
        add(1 - (own & 1), 1 - (own >> 1 & 1), 1 - (own >> 2 & 1));
    }

    /** Writes the normal of the single wedge as raw float32 bits. */
    public void put(int[] to) {
        for (int k = 0; k < 3; k++) to[k] = shownBits(0, k, unitScale(0));
    }

    private int shownBits(int wedge, int axis, double scale) {
        double x = scale > 0 ? scale * component(wedge, axis) : axis == 2 ? 1 : 0;
        return Float.floatToIntBits((float) x);
    }

    void addFace(Mesh mesh, int face) {
        for (int j = 0; j < 3; j++) {
            int v = mesh.vertex(face, j);
            for (int a = 0; a < 3; a++) at[3 * j + a] = mesh.positions()[3 * v + a];
        }
        int[] wedges = mesh.faceWedges();
        add(wedges[3 * face], wedges[3 * face + 1], wedges[3 * face + 2]);
    }

    private void add(int a, int b, int c) {
        double ux = at[3] - at[0];
        double uy = at[4] - at[1];
        double uz = at[5] - at[2];
        double vx = at[6] - at[0];
        double vy = at[7] - at[1];
        double vz = at[8] - at[2];
        double x = uy * vz - uz * vy;
        double y = uz * vx - ux * vz;
        double z = ux * vy - uy * vx;
        double length = Math.sqrt(x * x + y * y + z * z);
        if (length == 0) return;
        if (weight == NormalFormula.AREA) {
            add(a, x, y, z, 1, length);
            add(b, x, y, z, 1, length);
            add(c, x, y, z, 1, length);
            return;
        }
        x /= length;
        y /= length;
        z /= length;
        if (weight == NormalFormula.UNIFORM) {
            add(a, x, y, z, 1, 1);
            add(b, x, y, z, 1, 1);
            add(c, x, y, z, 1, 1);
            return;
        }
        addByAngle(a, 0, 3, 6, x, y, z, length);
        addByAngle(b, 3, 6, 0, x, y, z, length);
        addByAngle(c, 6, 0, 3, x, y, z, length);
    }

    private void addByAngle(int wedge, int i, int j, int k, double x, double y, double z, double cross) {
        double ux = at[j] - at[i];
        double uy = at[j + 1] - at[i + 1];
        double uz = at[j + 2] - at[i + 2];
        double vx = at[k] - at[i];
        double vy = at[k + 1] - at[i + 1];
        double vz = at[k + 2] - at[i + 2];
        double u = Math.sqrt(ux * ux + uy * uy + uz * uz);
        double v = Math.sqrt(vx * vx + vy * vy + vz * vz);
        double dot = ux * vx + uy * vy + uz * vz;
        double angle = arcTangent(cross, dot + u * v) * 2; // tan(a/2) = sin a / (1 + cos a)
        add(wedge, x, y, z, angle, angle);
    }

    private void add(int wedge, double x, double y, double z, double factor, double total) {
        sums[4 * wedge] += x * factor;
        sums[4 * wedge + 1] += y * factor;
        sums[4 * wedge + 2] += z * factor;
        sums[4 * wedge + 3] += total;
    }

    /** The angle of the vector (x, y), y ≥ 0, up to a right one: halved twice, then the series of the arc tangent. */
    static double arcTangent(double y, double x) {
        if (x <= 0) return HALF_PI;
        if (y > x) return HALF_PI - arcTangent(x, y);
        return series(tangentOfHalf(tangentOfHalf(y / x))) * 4;
    }

    private static double tangentOfHalf(double t) {
        return t / (Math.sqrt(t * t + 1) + 1);
    }

    private static double series(double t) {
        double sum = 0;
        for (int n = 2 * ATAN_TERMS - 1; n > 0; n -= 2) {
            double term = 1.0 / n;
            sum = term - sum * t * t;
        }
        return sum * t;
    }

    /** A component of the sum; exactly 0 where it is only rounding. */
    double component(int wedge, int axis) {
        double x = sums[4 * wedge + axis];
        return Math.abs(x) <= sums[4 * wedge + 3] * NOTHING ? 0 : x;
    }

    /** The factor that makes the sum a unit vector; 0 when there is none. */
    double unitScale(int wedge) {
        double x = component(wedge, 0);
        double y = component(wedge, 1);
        double z = component(wedge, 2);
        double length = Math.sqrt(x * x + y * y + z * z);
        return length == 0 ? 0 : 1 / length;
    }

    /** How much the faces' normals differ: 0 when they are parallel, towards 1 when they cancel out. */
    double disagreement(int wedge) {
        double x = sums[4 * wedge];
        double y = sums[4 * wedge + 1];
        double z = sums[4 * wedge + 2];
        double total = sums[4 * wedge + 3];
        if (total == 0) return 1;
        return Math.max(0, 1 - Math.sqrt(x * x + y * y + z * z) / total);
    }
}
