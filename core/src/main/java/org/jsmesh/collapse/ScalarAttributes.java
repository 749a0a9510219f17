package org.jsmesh.collapse;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Sizes;

/**
 * The scalar attributes S of a mesh under simplification, and what section 3 of Chen and Nishita 2002 derives from
 * them: sharp edges, and the weight of every other edge. The weight is the difference of the attributes at the edge's
 * two ends.
 *
 * <p>Corners of a vertex between two sharp edges form a group with common attributes. Its normal is that of the file,
 * of unit length. Without normals in the file it is the mean normal of the group's faces by area, and faces that meet
 * at more than {@link #CREASE_DEGREES} are of different groups. Colours and custom channels are part of the difference
 * too, custom ones divided by the range of their values. Texture coordinates are not, because they differ between any
 * two vertices; their seams are sharp.
 */
public final class ScalarAttributes {
    /** Smallest angle between the normals of faces that makes their edge sharp when normals are computed. */
    public static final double CREASE_DEGREES = 30;

    private static final int NORMAL = 3;

    private final Mesh mesh;
    private final CornerTable table;
    private final FaceNormals assigned; // or null when the file has normals
    private final int[] groups; // 4 per real face
    private final int components;
    private final float[] values;
    private int groupCount;

    /** @param table of the mesh, as it is before the first collapse; its first faces are those of the mesh */
    public ScalarAttributes(Mesh mesh, CornerTable table) {
        this.mesh = mesh;
        this.table = table;
        Channel normals = mesh.channel(Channel.Semantic.NORMAL);
        assigned = normals == null ? new FaceNormals(mesh, CREASE_DEGREES) : null;
        groups = new int[4 * mesh.faces()];
        int[] first = new int[3 * mesh.faces() + 1]; // corner of each group
        for (int v = 0; v < table.vertices(); v++) if (table.cornerOf(v) >= 0) group(v, first);
        List<Channel> others = new ArrayList<>();
        int n = NORMAL;
        for (Channel c : mesh.channels()) {
            if (c.semantic() != Channel.Semantic.COLOUR && c.semantic() != Channel.Semantic.CUSTOM) continue;
            others.add(c);
            n += c.components();
        }
        components = n;
        values = new float[Sizes.of(n, groupCount, "different corners of " + n + " numbers")];
        if (normals == null) assignNormals();
        else copyNormals(normals, first);
        int at = NORMAL;
        for (Channel c : others) {
            copy(c, first, at);
            at += c.components();
        }
    }

    private void group(int v, int[] first) {
        int begin = table.cornerOf(v);
        int c = begin;
        do {
            int next = table.swing(c);
            if (isBreak(c, next)) {
                begin = next;
                break;
            }
            c = next;
        } while (c != begin);
        c = begin;
        boolean open = false;
        do {
            int next = table.swing(c);
            if (isReal(c)) {
                if (!open) first[groupCount++] = c;
                open = !isBreak(c, next);
                groups[at(c)] = groupCount - 1;
            }
            c = next;
        } while (c != begin);
    }

    /** Are two corners, neighbours about a vertex, of different groups? */
    private boolean isBreak(int c, int next) {
        if (!isReal(c) || !isReal(next)) return true;
        int f = CornerTable.face(c);
        int g = CornerTable.face(next);
        return mesh.faceWedges()[3 * f + (c & 3)] != mesh.faceWedges()[3 * g + (next & 3)]
                || assigned != null && assigned.isCrease(f, g);
    }

    private void assignNormals() {
        double[] sums = new double[NORMAL * groupCount];
        for (int f = 0; f < mesh.faces(); f++) {
            for (int j = 0; j < 3; j++) assigned.addTo(sums, NORMAL * groups[4 * f + j], f);
        }
        for (int g = 0; g < groupCount; g++) putNormal(g, sums[3 * g], sums[3 * g + 1], sums[3 * g + 2]);
    }

    private void copyNormals(Channel normals, int[] first) {
        for (int g = 0; g < groupCount; g++) {
            int wedge = wedge(first[g]);
            if (normals.components() == NORMAL && !normals.isAbsent(wedge))
                putNormal(g, normals.number(wedge, 0), normals.number(wedge, 1), normals.number(wedge, 2));
        }
    }

    private void putNormal(int group, double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        if (!(length > 0)) return;
        values[components * group] = (float) (x / length);
        values[components * group + 1] = (float) (y / length);
        values[components * group + 2] = (float) (z / length);
    }

    private void copy(Channel channel, int[] first, int at) {
        float range = range(channel);
        // colours are parts of 1, or whole numbers up to that of white
        float scale = channel.semantic() == Channel.Semantic.COLOUR && range <= 1 ? 1 : 1 / range;
        for (int g = 0; g < groupCount; g++) {
            int wedge = wedge(first[g]);
            if (channel.isAbsent(wedge)) continue;
            for (int i = 0; i < channel.components(); i++)
                values[components * g + at + i] = channel.number(wedge, i) * scale;
        }
    }

    /** Largest difference between finite values of a channel, or 1 when there is none. */
    private static float range(Channel channel) {
        float low = Float.POSITIVE_INFINITY;
        float high = Float.NEGATIVE_INFINITY;
        for (int w = 0; w < channel.wedges(); w++) {
            for (int i = 0; i < channel.components(); i++) {
                float x = channel.number(w, i);
                if (!Float.isFinite(x)) continue;
                low = Math.min(low, x);
                high = Math.max(high, x);
            }
        }
        float range = high - low;
        return range > 0 && Float.isFinite(range) ? range : 1;
    }

    private int wedge(int corner) {
        return mesh.faceWedges()[3 * CornerTable.face(corner) + (corner & 3)];
    }

    private boolean isReal(int corner) {
        return CornerTable.face(corner) < mesh.faces();
    }

    private static int at(int corner) {
        return 4 * CornerTable.face(corner) + (corner & 3);
    }

    /**
     * Is the edge from the vertex of a corner to {@code previous(corner)} sharp: a boundary, a change of material, or
     * of attributes at either end?
     */
    public boolean isSharp(int corner) {
        int other = table.swing(corner);
        if (!isReal(corner) || !isReal(other)) return true;
        int f = CornerTable.face(corner);
        int g = CornerTable.face(other);
        return mesh.faceMaterials()[f] != mesh.faceMaterials()[g]
                || groups[at(corner)] != groups[at(other)]
                || groups[at(CornerTable.previous(corner))] != groups[at(CornerTable.next(other))];
    }

    /**
     * Weight of the same edge when it is not sharp: length of the difference of the attributes at its ends; at most 2
     * from normals.
     */
    public float weight(int corner) {
        int a = components * groups[at(corner)];
        int b = components * groups[at(CornerTable.previous(corner))];
        double sum = 0;
        for (int i = 0; i < components; i++) {
            double d = (double) values[a + i] - values[b + i];
            sum += d * d;
        }
        return sum >= 0 ? (float) Math.sqrt(sum) : Float.POSITIVE_INFINITY; // a difference of NaN counts as infinite
    }

    /** Gives a corner the attributes of a corner of the vertex kept, when a collapse replaces its vertex. */
    public void join(int corner, int kept) {
        if (isReal(corner)) groups[at(corner)] = groups[at(kept)];
    }
}
