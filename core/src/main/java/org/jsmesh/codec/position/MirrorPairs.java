package org.jsmesh.codec.position;

import java.util.Arrays;
import org.jsmesh.codec.entropy.IntegerLog;
import org.jsmesh.codec.lattice.Lattice;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.mesh.KeyHash;

/** Finds vertices by the units of their mirror images. */
final class MirrorPairs {
    private static final KeyHash HASH = KeyHash.OF_THIS_RUN;

    private final LodMesh mesh;
    private final Lattice lattice;
    private final Mirror mirror;
    private int shift;
    private int[] images = new int[0]; // units of each vertex' image
    private int[] slots = new int[0]; // vertices, or −1; open addressing

    MirrorPairs(LodMesh mesh, Lattice lattice, Mirror mirror) {
        this.mesh = mesh;
        this.lattice = lattice;
        this.mirror = mirror;
    }

    /** Forgets all vertices; units have 2^shift cells from now on. */
    void begin(int shift) {
        this.shift = shift;
        if (images.length < 3 * mesh.vertices()) {
            images = new int[3 * mesh.vertices()];
            slots = new int[2 << IntegerLog.bits(mesh.vertices())];
        }
        Arrays.fill(slots, -1);
    }

    /** Per vertex the image among all of them, or −1. */
    int[] all(int shift) {
        begin(shift);
        int[] pairs = new int[mesh.vertices()];
        Arrays.fill(pairs, -1);
        for (int v = 0; v < pairs.length; v++) {
            int twin = find(v);
            if (twin >= 0 && pairs[twin] < 0) {
                pairs[v] = twin;
                pairs[twin] = v;
            }
            add(v);
        }
        return pairs;
    }

    /** Was the vertex there at the last {@link #begin}? */
    boolean holds(int vertex) {
        return 3 * vertex < images.length;
    }

    /**
     * The last vertex added whose image has the units of this one, or −1. Where units do not mirror each other exactly,
     * the image may also be one unit more or less away along the axis.
     */
    int find(int vertex) {
        int fan = 4 * mesh.firstFan(vertex);
        int[] cells = mesh.places();
        int x = cells[fan] >> shift;
        int y = cells[fan + 1] >> shift;
        int z = cells[fan + 2] >> shift;
        int found = slots[slot(x, y, z)];
        for (int off = -1; off <= 1 && found < 0 && !mirror.isExact(); off += 2)
            found = slots[
                    slot(
                            mirror.axis() == 0 ? x + off : x,
                            mirror.axis() == 1 ? y + off : y,
                            mirror.axis() == 2 ? z + off : z)];
        return found;
    }

    void add(int vertex) {
        int[] cells = mesh.places();
        int fan = 4 * mesh.firstFan(vertex);
        for (int a = 0; a < 3; a++) {
            int cell = cells[fan + a];
            images[3 * vertex + a] = (a == mirror.axis() ? mirror.cell(cell, lattice) : cell) >> shift;
        }
        slots[slot(images[3 * vertex], images[3 * vertex + 1], images[3 * vertex + 2])] = vertex;
    }

    private int slot(int x, int y, int z) {
        int mask = slots.length - 1;
        int slot = HASH.of(x, y, z) & mask;
        while (slots[slot] >= 0) {
            int at = 3 * slots[slot];
            if (images[at] == x && images[at + 1] == y && images[at + 2] == z) break;
            slot = slot + 1 & mask;
        }
        return slot;
    }
}
