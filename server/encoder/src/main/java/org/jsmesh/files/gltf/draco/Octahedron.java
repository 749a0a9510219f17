package org.jsmesh.files.gltf.draco;

import java.nio.ByteBuffer;
import org.jsmesh.files.gltf.packed.PackedBytes;
import org.jsmesh.files.gltf.packed.PackedException;

/**
 * Unit vectors as points of a square, which an octahedron is unfolded to, and corrections of predicted ones (Draco
 * specification, "Prediction normal transform").
 */
final class Octahedron implements Correction {
    private int center;
    /** How many values a coordinate has: twice the centre and one. */
    private int size;

    Octahedron() {}

    Octahedron(int bits) throws PackedException {
        setBits(bits);
    }

    private void setBits(int bits) throws PackedException {
        if (bits < 2 || bits > 30) throw new PackedException("normals of " + bits + " bits are out of range");
        size = (1 << bits) - 1;
        center = size / 2;
    }

    @Override
    public void readData(PackedBytes in) throws PackedException {
        int most = in.nextInt();
        in.nextInt();
        if (most <= 0 || most % 2 == 0) throw new PackedException("the range of the Draco normals is damaged");
        setBits(32 - Integer.numberOfLeadingZeros(most));
    }

    @Override
    public boolean isPositive() {
        return true;
    }

    @Override
    public void correct(int[] predicted, int from, int[] values, int at) {
        int s = predicted[from] - center;
        int t = predicted[from + 1] - center;
        boolean outside = Math.abs(s) + Math.abs(t) > center;
        if (outside) {
            int inverted = invertedS(s, t);
            t = invertedT(s, t);
            s = inverted;
        }
        int turns = turns(s, t);
        int turnedS = turnedS(s, t, turns);
        int turnedT = turnedT(s, t, turns);
        int x = wrapped(turnedS + values[at]);
        int y = wrapped(turnedT + values[at + 1]);
        s = turnedS(x, y, (4 - turns) % 4);
        t = turnedT(x, y, (4 - turns) % 4);
        if (outside) {
            int inverted = invertedS(s, t);
            t = invertedT(s, t);
            s = inverted;
        }
        values[at] = s + center;
        values[at + 1] = t + center;
    }

    /** How often a point is turned by a right angle to come to the lower left quarter. */
    private static int turns(int s, int t) {
        if (s == 0) return t == 0 ? 0 : t > 0 ? 3 : 1;
        if (s > 0) return t >= 0 ? 2 : 1;
        return t <= 0 ? 0 : 3;
    }

    private static int turnedS(int s, int t, int turns) {
        return switch (turns) {
            case 1 -> t;
            case 2 -> -s;
            case 3 -> -t;
            default -> s;
        };
    }

    private static int turnedT(int s, int t, int turns) {
        return switch (turns) {
            case 1 -> -s;
            case 2 -> -t;
            case 3 -> s;
            default -> t;
        };
    }

    private int wrapped(int value) {
        return value > center ? value - size : value < -center ? value + size : value;
    }

    /** The point across the edge of the inner diamond. */
    private int invertedS(int s, int t) {
        int signS = signS(s, t);
        int other = signS * signT(s, t) >= 0 ? -(2 * t - signT(s, t) * center) : 2 * t - signT(s, t) * center;
        return (other + signS * center) / 2;
    }

    private int invertedT(int s, int t) {
        int signT = signT(s, t);
        int other = signS(s, t) * signT >= 0 ? -(2 * s - signS(s, t) * center) : 2 * s - signS(s, t) * center;
        return (other + signT * center) / 2;
    }

    private static int signS(int s, int t) {
        return s >= 0 && t >= 0 || s > 0 && t > 0 ? 1 : s <= 0 && t <= 0 ? -1 : s > 0 ? 1 : -1;
    }

    private static int signT(int s, int t) {
        return s >= 0 && t >= 0 ? 1 : s <= 0 && t <= 0 ? -1 : t > 0 ? 1 : -1;
    }

    /** Scales a vector to the octahedron, negates it if asked for, and gives its point in the square. */
    void toPoint(long[] vector, boolean negated, int[] point) {
        long sum = Math.abs(vector[0]) + Math.abs(vector[1]) + Math.abs(vector[2]);
        int x = sum == 0 ? center : (int) (vector[0] * center / sum);
        int y = sum == 0 ? 0 : (int) (vector[1] * center / sum);
        int z = center - Math.abs(x) - Math.abs(y);
        if (sum != 0 && vector[2] < 0) z = -z;
        if (negated) {
            x = -x;
            y = -y;
            z = -z;
        }
        int most = 2 * center;
        int s = x >= 0 ? y + center : y < 0 ? Math.abs(z) : most - Math.abs(z);
        int t = x >= 0 ? z + center : z < 0 ? Math.abs(y) : most - Math.abs(y);
        // Points of the border stand for the same vector as another, of which one is used.
        if (s == 0 && t == 0 || s == 0 && t == most || s == most && t == 0) {
            s = most;
            t = most;
        } else if (s == 0 && t > center || s == most && t < center) {
            t = most - t;
        } else if (t == most && s < center || t == 0 && s > center) {
            s = most - s;
        }
        point[0] = s;
        point[1] = t;
    }

    /** Appends the unit vector of a point of the square. */
    void putVector(int s, int t, ByteBuffer to) {
        float scale = 2f / (size - 1);
        float y = s * scale - 1;
        float z = t * scale - 1;
        float x = 1 - Math.abs(y) - Math.abs(z);
        float fold = Math.max(0, -x);
        y += y < 0 ? fold : -fold;
        z += z < 0 ? fold : -fold;
        float square = x * x + y * y + z * z;
        float inverse = square < 1e-6 ? 0 : 1 / (float) Math.sqrt(square);
        to.putFloat(x * inverse).putFloat(y * inverse).putFloat(z * inverse);
    }
}
