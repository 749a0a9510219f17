package org.jsmesh.codec.position;

import java.util.Arrays;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.mesh.CornerTable;

/**
 * The mirror images of wedges. The image of a wedge is found at a corner of it: the wedge in the image of the corner's
 * face, else the wedge in a face at the image of one of the corner's two edges.
 */
public final class WedgeTwins {
    public final Mirror mirror;
    private final int[] twin; // or −1
    private final LodMesh mesh;
    private final int[] images; // vertices, or −1

    /** @param images per vertex, or −1 */
    WedgeTwins(LodMesh mesh, Mirror mirror, int[] images) {
        this.mesh = mesh;
        this.mirror = mirror;
        this.images = images;
        CornerTable t = mesh.table();
        twin = new int[mesh.wedges()];
        Arrays.fill(twin, -1);
        boolean[] isSure = new boolean[twin.length];
        int end = CornerTable.STRIDE * t.faces();
        for (int c = 0; c < end; c++) {
            if ((c & 7) >= 3 || t.isDummy(CornerTable.face(c))) continue;
            int wedge = mesh.wedge(c);
            if (!isSure[wedge]) isSure[wedge] = find(wedge, c);
        }
    }

    /** The image of a wedge, or −1. */
    public int of(int wedge) {
        return twin[wedge];
    }

    /** Looks for the image of a corner. Returns true when it is a corner of the face's image. */
    private boolean find(int wedge, int c) {
        CornerTable t = mesh.table();
        int image = image(t.vertex(c));
        if (image < 0) return false;
        int ahead = image(t.vertex(CornerTable.previous(c)));
        int behind = image(t.vertex(CornerTable.next(c)));
        for (int fan = mesh.firstFan(image); fan >= 0; fan = mesh.nextFan(fan) == 0 ? -1 : mesh.nextFan(fan)) {
            int start = t.cornerOf(fan);
            int k = start;
            do {
                if (!t.isDummy(CornerTable.face(k))) {
                    boolean sameAhead = ahead >= 0 && vertex(CornerTable.next(k)) == ahead;
                    boolean sameBehind = behind >= 0 && vertex(CornerTable.previous(k)) == behind;
                    if (sameAhead && sameBehind) {
                        twin[wedge] = mesh.wedge(k);
                        return true;
                    }
                    if ((sameAhead || sameBehind) && twin[wedge] < 0) twin[wedge] = mesh.wedge(k);
                }
                k = t.swing(k);
            } while (k != start);
        }
        return false;
    }

    private int vertex(int c) {
        return mesh.vertexOf(mesh.table().vertex(c));
    }

    private int image(int fan) {
        return images[mesh.vertexOf(fan)];
    }
}
