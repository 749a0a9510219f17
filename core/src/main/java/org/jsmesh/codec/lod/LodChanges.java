package org.jsmesh.codec.lod;

import java.util.Arrays;
import java.util.BitSet;

/**
 * Notes what happens to a {@link LodMesh} while it is decoded, and keeps numbers of vertices and faces that stay when
 * the mesh gives them new ones: their order of arrival.
 */
public final class LodChanges {
    private int[] vertexOf; // present number of each arrival; null while they are the same
    private int[] arrivalOf; // of each present vertex
    private int[] faceOf;
    private int[] faceArrivalOf;
    private int seenFans; // vertices and faces that somebody has looked at
    private int[] parents = new int[64]; // arrival of the fan that each fan not seen was split from, or −1
    private int fans; // that have parents noted, among those not seen
    private int[] lastParents = new int[0]; // the same of those that were looked at last
    private int lastSeen;
    private int lastFans;
    private final BitSet moved = new BitSet(); // by arrival
    private final BitSet wedges = new BitSet();

    /** A fan vertex came from a split. */
    void split(int fan, int parent) {
        int at = fan - seenFans;
        if (at >= parents.length) parents = Arrays.copyOf(parents, Math.max(at + 1, 2 * at));
        if (at > fans) Arrays.fill(parents, fans, at, -1);
        parents[at] = vertexArrival(parent);
        fans = at + 1;
    }

    /** The positions of vertices from one number to before another are others. */
    public void move(int from, int to) {
        if (vertexOf == null) moved.set(from, to);
        else for (int v = from; v < to; v++) moved.set(vertexArrival(v));
    }

    /** The attributes of a wedge are others. */
    public void changeWedge(int wedge) {
        wedges.set(wedge);
    }

    void renumber(Renumbering numbers) {
        int[] old = numbers.oldVertex;
        int[] arrivals = new int[old.length];
        int[] present = new int[old.length];
        for (int v = 0; v < old.length; v++) {
            arrivals[v] = vertexArrival(old[v]);
            present[arrivals[v]] = v;
        }
        int[] faces = numbers.newFace;
        int[] faceArrivals = new int[faces.length];
        int[] presentFaces = new int[faces.length];
        for (int f = 0; f < faces.length; f++) {
            int arrival = faceArrival(f);
            faceArrivals[faces[f]] = arrival;
            presentFaces[arrival] = faces[f];
        }
        arrivalOf = arrivals;
        vertexOf = present;
        faceArrivalOf = faceArrivals;
        faceOf = presentFaces;
    }

    /** The number that stays of a vertex. */
    public int vertexArrival(int vertex) {
        return arrivalOf == null || vertex >= arrivalOf.length ? vertex : arrivalOf[vertex];
    }

    /** The present number of a vertex. */
    public int vertex(int arrival) {
        return vertexOf == null || arrival >= vertexOf.length ? arrival : vertexOf[arrival];
    }

    /** The number that stays of a face. */
    public int faceArrival(int face) {
        return faceArrivalOf == null || face >= faceArrivalOf.length ? face : faceArrivalOf[face];
    }

    /** The present number of a face. */
    public int face(int arrival) {
        return faceOf == null || arrival >= faceOf.length ? arrival : faceOf[arrival];
    }

    /** The arrival of the fan that a fan was split from, of those that were new at the last look; −1 for none. */
    public int parent(int fanArrival) {
        int at = fanArrival - lastSeen;
        return at >= 0 && at < lastFans ? lastParents[at] : -1;
    }

    /** The first fan that nobody has looked at, by arrival. */
    public int firstNew() {
        return seenFans;
    }

    /** Vertices that have moved, by arrival. */
    public BitSet moved() {
        return moved;
    }

    /** Wedges whose attributes are others. */
    public BitSet wedges() {
        return wedges;
    }

    /** Somebody has looked at all there is. */
    public void settle(int allFans) {
        int[] spare = lastParents;
        lastParents = parents;
        lastSeen = seenFans;
        lastFans = fans;
        parents = spare;
        seenFans = allFans;
        fans = 0;
        moved.clear();
        wedges.clear();
    }
}
