package org.jsmesh.codec.position;

import java.util.Arrays;
import org.jsmesh.codec.lattice.Lattice;
import org.jsmesh.mesh.KeyHash;

/**
 * Makes the moves of vertices that are mirror images of each other mirror images too, so that the moved vertices still
 * are images. The encoder's side.
 */
public final class MirroredMoves {
    private static final KeyHash HASH = KeyHash.OF_THIS_RUN;

    private final int[] bits; // x y z per vertex
    private final Lattice lattice;
    private final Mirror mirror;
    private final int[] moves;
    private final long[] byHash; // hash of the position << 32 | vertex, of those that are moved
    private final int[] image = new int[3];

    private MirroredMoves(int[] bits, Lattice lattice, Mirror mirror, int[] moves) {
        this.bits = bits;
        this.lattice = lattice;
        this.mirror = mirror;
        this.moves = moves;
        long[] all = new long[bits.length / 3];
        int n = 0;
        for (int v = 0; v < all.length; v++) {
            if ((moves[3 * v] | moves[3 * v + 1] | moves[3 * v + 2]) != 0)
                all[n++] = hash(bits[3 * v], bits[3 * v + 1], bits[3 * v + 2]) | v;
        }
        byHash = Arrays.copyOf(all, n);
        Arrays.sort(byHash);
    }

    /** @param moves in cells, of all vertices; a vertex that does not move counts as having no image */
    public static void symmetrize(int[] bits, Lattice lattice, Mirror mirror, int[] moves) {
        MirroredMoves all = new MirroredMoves(bits, lattice, mirror, moves);
        for (long vertex : all.byHash) all.symmetrize((int) vertex);
    }

    private static long hash(int x, int y, int z) {
        return (long) HASH.of(x, y, z) << 32;
    }

    private void symmetrize(int v) {
        int axis = mirror.axis();
        for (int a = 0; a < 3; a++) image[a] = bits[3 * v + a];
        image[axis] = mirror.bits(image[axis], lattice);
        int w = vertexAt(image[0], image[1], image[2]);
        if (w < v) return; // there is none, or both have been here
        for (int a = 0; a < 3; a++) {
            int own = moves[3 * v + a];
            int other = moves[3 * w + a];
            moves[3 * v + a] = a == axis ? own - other >> 1 : own + other >> 1;
            moves[3 * w + a] = a == axis ? -(own - other >> 1) : own + other >> 1;
        }
    }

    private int vertexAt(int x, int y, int z) {
        long hash = hash(x, y, z);
        int i = Arrays.binarySearch(byHash, hash);
        for (i = i < 0 ? -1 - i : i; i < byHash.length && byHash[i] >> 32 == hash >> 32; i++) {
            int v = (int) byHash[i];
            if (bits[3 * v] == x && bits[3 * v + 1] == y && bits[3 * v + 2] == z) return v;
        }
        return -1;
    }
}
