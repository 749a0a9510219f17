package org.jsmesh.display;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.GrowingMesh;

/**
 * The normals of the corners around one vertex after the other, as {@link CornerNormals} has them. Knows which vertices
 * need others because the crease angle is another one.
 */
final class LiveNormals {
    private static final int CORNER = GrowingMesh.CORNER;
    private static final int NONE = -1;

    private final GrowingMesh mesh;
    private final int given; // channel, or −1
    private final StarNormals star = new StarNormals();
    private float[] steadyUpTo = new float[0]; // crease cosine up to which a vertex needs no new normals
    private int known; // vertices
    private double creaseCosine = -1;

    LiveNormals(GrowingMesh mesh) {
        this.mesh = mesh;
        given = given(mesh.channels());
    }

    /** As {@link CornerNormals#given} finds it: the first channel of normals, if it has three components. */
    private static int given(List<Channel> channels) {
        for (int i = 0; i < channels.size(); i++)
            if (channels.get(i).semantic() == Channel.Semantic.NORMAL)
                return channels.get(i).components() == 3 ? i : NONE;
        return NONE;
    }

    /** Begins a step: marks the vertices at which creases may be others now. */
    void begin(double cosine, BitSet changed) {
        if (cosine < creaseCosine) changed.set(0, known);
        if (cosine > creaseCosine) for (int v = 0; v < known; v++) if (steadyUpTo[v] < cosine) changed.set(v);
        creaseCosine = cosine;
        known = mesh.vertices();
        if (known > steadyUpTo.length) steadyUpTo = Arrays.copyOf(steadyUpTo, known + known / 2);
    }

    /**
     * Computes the normals around a vertex.
     *
     * @param corners of the vertex, see {@link GrowingMesh#corners}
     * @param size numbers of these
     */
    void compute(int vertex, int[] corners, int size, float[] positions) {
        steadyUpTo[vertex] = Float.POSITIVE_INFINITY;
        if (areAllGiven(corners, size)) return;
        star.begin();
        int own = 3 * vertex;
        for (int i = 0; i < size; i += CORNER) {
            int next = 3 * corners[i + 3];
            int last = 3 * corners[i + 4];
            // A face is measured from the first of its corners, so that it is the same to the last bit from all of
            // them.
            if (corners[i + 1] == 0) star.add(positions, own, next, last);
            else if (corners[i + 1] == 1) star.add(positions, last, own, next);
            else star.add(positions, next, last, own);
        }
        star.compute(creaseCosine);
        steadyUpTo[vertex] = (float) star.steadyUpTo();
    }

    private boolean areAllGiven(int[] corners, int size) {
        if (given == NONE) return false;
        for (int i = 0; i < size; i += CORNER) if (!isGiven(corners[i + 2])) return false;
        return true;
    }

    private boolean isGiven(int wedge) {
        if (given == NONE || mesh.isAbsent(given, wedge)) return false;
        return CornerNormals.isThere(mesh.values(given, wedge), 0);
    }

    /** Writes the normal of a corner, by its place among those of the vertex. */
    void copy(int corner, int wedge, float[] to) {
        if (isGiven(wedge)) {
            CornerNormals.put(mesh.values(given, wedge), 0, to, 0);
            return;
        }
        float[] computed = star.normals();
        for (int a = 0; a < 3; a++) to[a] = computed[3 * corner + a];
    }
}
