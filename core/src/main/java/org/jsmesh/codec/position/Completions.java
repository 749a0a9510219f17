package org.jsmesh.codec.position;

import org.jsmesh.codec.connectivity.ConnectivityCoder;
import org.jsmesh.codec.connectivity.SplitLane;
import org.jsmesh.codec.lod.LodMesh;

/**
 * Where a new vertex would complete its ring to a regular grid, in the two axes across the normal. Scanned and remeshed
 * models were regular once, and collapses leave holes in that. The new vertex is then the fourth corner of
 * parallelograms: of three neighbours in a row, of two neighbours and the vertex beyond their edge; and it lies in the
 * middle of opposite neighbours. Most of these meet in it where neighbours are missing or too many, unlike their mean:
 * so the median of each coordinate counts.
 */
final class Completions {
    private static final int MOST = 3 * (ConnectivityCoder.MAX_VALENCE + 2);
    private final LodMesh mesh;
    private final Ring ring;
    private final int[] first = new int[MOST]; // twice the coordinates
    private final int[] second = new int[MOST];
    private int count;

    Completions(LodMesh mesh, Ring ring) {
        this.mesh = mesh;
        this.ring = ring;
    }

    /**
     * Finds the completions of the ring.
     *
     * @param beyond the vertices beyond the edges from each neighbour to the next, negative where there are none
     * @param from index of the first
     */
    void find(int[] beyond, int from) {
        int n = ring.size;
        int f = ring.first;
        int g = ring.second;
        boolean reaches = n <= SplitLane.FEW && !ring.isOpen;
        int half = n >> 1;
        int pairs = (n & 1) == 0 ? half : n;
        int[] places = mesh.places();
        int[] neighbour = ring.neighbour;
        int k = 0;
        int at = 4 * neighbour[n - 1];
        int beforeF = places[at + f];
        int beforeG = places[at + g];
        at = 4 * neighbour[0];
        int hereF = places[at + f];
        int hereG = places[at + g];
        for (int i = 0; i < n; i++) {
            at = 4 * neighbour[i + 1 == n ? 0 : i + 1];
            int afterF = places[at + f];
            int afterG = places[at + g];
            first[k] = 2 * (beforeF + afterF - hereF);
            second[k++] = 2 * (beforeG + afterG - hereG);
            if (i < pairs) {
                at = 4 * neighbour[i + half >= n ? i + half - n : i + half];
                first[k] = hereF + places[at + f];
                second[k++] = hereG + places[at + g];
            }
            if (reaches && beyond[from + i] >= 0) {
                at = 4 * beyond[from + i];
                first[k] = 2 * (hereF + afterF - places[at + f]);
                second[k++] = 2 * (hereG + afterG - places[at + g]);
            }
            beforeF = hereF;
            beforeG = hereG;
            hereF = afterF;
            hereG = afterG;
        }
        count = k;
        SmallSort.sort(first, k);
        SmallSort.sort(second, k);
    }

    double firstMedian() {
        return median(first);
    }

    double secondMedian() {
        return median(second);
    }

    /** Cells between the quartiles. */
    double firstRange() {
        return range(first);
    }

    double secondRange() {
        return range(second);
    }

    private double median(int[] sorted) {
        return .25 * ((double) sorted[count >> 1] + sorted[count - 1 >> 1]);
    }

    private double range(int[] sorted) {
        return .5 * ((double) sorted[3 * count >> 2] - sorted[count >> 2]);
    }
}
