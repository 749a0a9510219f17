package org.jsmesh.encode.measure;

/** Orders triangles by their centroids along an axis. */
final class Centroids {
    private Centroids() {}

    static float[] of(float[] positions, int[] triangles, int size) {
        float[] centroids = new float[3 * size];
        for (int i = 0; i < size; i++) {
            int a = 3 * triangles[3 * i];
            int b = 3 * triangles[3 * i + 1];
            int c = 3 * triangles[3 * i + 2];
            for (int axis = 0; axis < 3; axis++) {
                centroids[3 * i + axis] = (positions[a + axis] + positions[b + axis] + positions[c + axis]) / 3;
            }
        }
        return centroids;
    }

    static int longestAxis(int[] order, float[] centroids, int from, int n) {
        int longest = 0;
        float length = -1;
        for (int axis = 0; axis < 3; axis++) {
            float low = Float.POSITIVE_INFINITY;
            float high = Float.NEGATIVE_INFINITY;
            for (int i = from; i < from + n; i++) {
                float x = centroids[3 * order[i] + axis];
                if (x < low) low = x;
                if (x > high) high = x;
            }
            if (high - low > length) {
                length = high - low;
                longest = axis;
            }
        }
        return longest;
    }

    /** Hoare's quickselect: the k smallest along an axis come to the front. */
    static void select(int[] order, float[] centroids, int axis, int low, int high, int k) {
        while (low < high) {
            float pivot = centroids[3 * order[(low + high) >>> 1] + axis];
            int i = low;
            int j = high;
            while (i <= j) {
                while (centroids[3 * order[i] + axis] < pivot) i++;
                while (centroids[3 * order[j] + axis] > pivot) j--;
                if (i > j) break;
                int t = order[i];
                order[i++] = order[j];
                order[j--] = t;
            }
            if (k <= j) high = j;
            else if (k >= i) low = i;
            else return;
        }
    }
}
