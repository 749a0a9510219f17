package org.jsmesh.files.gltf.read;

import com.fasterxml.jackson.databind.JsonNode;
import org.jsmesh.files.gltf.json.JsonTree;
import org.jsmesh.mesh.io.ModelFormatException;

/**
 * A 4 × 4 matrix of doubles, column after column as in glTF. Sums are taken from left to right; points are not rounded
 * here (see {@link WorldPositions}).
 */
final class Transform {
    private static final double[] UNIT = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

    static final double[] NO_MOVE = {0, 0, 0};
    static final double[] NO_TURN = {0, 0, 0, 1};
    static final double[] NO_SCALE = {1, 1, 1};

    static final Transform IDENTITY = new Transform(UNIT);

    private final double[] m;
    private final boolean identity;
    private final boolean keepsNormals;

    private Transform(double[] m) {
        this.m = m;
        boolean unit = true;
        for (int i = 0; i < 12; i++) unit &= m[i] == UNIT[i];
        keepsNormals = m[0] > 0 && isScaled(m);
        for (int i = 12; i < 16; i++) unit &= m[i] == UNIT[i];
        identity = unit;
    }

    /** Is the upper left 3 × 3 matrix the unit one, times a number? */
    private static boolean isScaled(double[] m) {
        for (int i = 0; i < 12; i++) if (Math.abs(m[i] - UNIT[i] * m[0]) > 0) return false;
        return true;
    }

    /** The local transform of a node: its matrix, or translation × rotation × scale. */
    static Transform of(GltfDocument document, JsonNode node, String name) throws ModelFormatException {
        JsonNode matrix = node.path("matrix");
        if (JsonTree.isGiven(matrix) && !(matrix.isArray() && matrix.isEmpty()))
            return new Transform(numbers(document, node, "matrix", name, UNIT));
        return of(
                numbers(document, node, "translation", name, NO_MOVE),
                numbers(document, node, "rotation", name, NO_TURN),
                numbers(document, node, "scale", name, NO_SCALE));
    }

    /**
     * Translation × rotation × scale.
     *
     * @param t move
     * @param q quaternion x, y, z, w
     * @param s factor of each axis
     */
    static Transform of(double[] t, double[] q, double[] s) {
        double x = q[0];
        double y = q[1];
        double z = q[2];
        double w = q[3];
        return new Transform(new double[] {
            (1 - 2 * (y * y + z * z)) * s[0],
            2 * (x * y + z * w) * s[0],
            2 * (x * z - y * w) * s[0],
            0,
            2 * (x * y - z * w) * s[1],
            (1 - 2 * (x * x + z * z)) * s[1],
            2 * (y * z + x * w) * s[1],
            0,
            2 * (x * z + y * w) * s[2],
            2 * (y * z - x * w) * s[2],
            (1 - 2 * (x * x + y * y)) * s[2],
            0,
            t[0],
            t[1],
            t[2],
            1
        });
    }

    /** An array that is not given, or empty, stands for its default. */
    private static double[] numbers(GltfDocument document, JsonNode node, String key, String name, double[] otherwise)
            throws ModelFormatException {
        JsonNode array = node.path(key);
        if (!JsonTree.isGiven(array) || array.isArray() && array.isEmpty()) return otherwise;
        double[] values = new double[otherwise.length];
        boolean fits = array.isArray() && array.size() == values.length;
        for (int i = 0; fits && i < values.length; i++) {
            values[i] = array.get(i).asDouble();
            fits = array.get(i).isNumber();
        }
        if (!fits) throw document.error(name + " has a " + key + " that is not " + values.length + " numbers");
        return values;
    }

    /** This transform after another: {@code this × local}. */
    Transform times(Transform local) {
        if (identity) return local;
        if (local.identity) return this;
        double[] product = new double[16];
        for (int column = 0; column < 4; column++) {
            for (int row = 0; row < 4; row++) {
                double sum = 0;
                for (int k = 0; k < 4; k++) sum += m[4 * k + row] * local.m[4 * column + k];
                product[4 * column + row] = sum;
            }
        }
        return new Transform(product);
    }

    /** Whether it turns faces over, so that their orientation must be turned back. */
    boolean mirrors() {
        return determinant() < 0;
    }

    private double determinant() {
        return m[0] * cofactor(0, 0) + m[1] * cofactor(1, 0) + m[2] * cofactor(2, 0);
    }

    /** Of the upper left 3 × 3 matrix. */
    private double cofactor(int row, int column) {
        int r1 = (row + 1) % 3;
        int r2 = (row + 2) % 3;
        int c1 = 4 * ((column + 1) % 3);
        int c2 = 4 * ((column + 2) % 3);
        return m[c1 + r1] * m[c2 + r2] - m[c2 + r1] * m[c1 + r2];
    }

    void point(double[] p) {
        if (identity) return;
        double x = p[0];
        double y = p[1];
        double z = p[2];
        for (int row = 0; row < 3; row++) p[row] = m[row] * x + m[4 + row] * y + m[8 + row] * z + m[12 + row];
    }

    /** Do directions stay as they are? Moves and even scales change none. */
    boolean keepsDirections() {
        return keepsNormals;
    }

    /**
     * Transforms by the inverse transpose and makes the result a unit vector. The cofactors give its direction without
     * a division. A zero vector stays, and zeros get no sign.
     */
    void normal(float[] n) {
        if (keepsNormals) return;
        double sign = mirrors() ? -1 : 1;
        double[] r = new double[3];
        for (int row = 0; row < 3; row++)
            r[row] = sign * (cofactor(row, 0) * n[0] + cofactor(row, 1) * n[1] + cofactor(row, 2) * n[2]);
        unit(r, n);
    }

    /** Transforms a direction along the surface and makes the first three components a unit vector; others stay. */
    void tangent(float[] t) {
        if (keepsNormals) return;
        double[] r = new double[3];
        for (int row = 0; row < 3; row++) r[row] = m[row] * t[0] + m[4 + row] * t[1] + m[8 + row] * t[2];
        unit(r, t);
    }

    private static void unit(double[] r, float[] to) {
        double length = Math.sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
        for (int row = 0; row < 3; row++) to[row] = length > 0 ? (float) (r[row] / length + 0.0) : 0f;
    }
}
