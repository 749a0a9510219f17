package org.jsmesh.display;

import java.util.Arrays;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.GrowingMesh;

/**
 * The attributes of render vertices, kept in step with a {@link GrowingMesh}: colours, tangents, texture coordinates.
 */
final class LiveAttributes {
    private static final int NONE = -1;

    private final GrowingMesh mesh;
    private final LiveArray[] arrays;
    private final int[] channels = new int[LiveMesh.ARRAYS]; // of each array, or −1
    private double full = 1; // light of colours

    LiveAttributes(GrowingMesh mesh, LiveArray[] arrays) {
        this.mesh = mesh;
        this.arrays = arrays;
        List<Channel> all = mesh.channels();
        Arrays.fill(channels, NONE);
        for (int i = all.size() - 1; i >= 0; i--)
            if (all.get(i).semantic() == Channel.Semantic.COLOUR) channels[LiveMesh.COLOURS] = i;
        for (int i = all.size() - 1; i >= 0; i--)
            if (RenderMeshBuilder.areTangents(all.get(i))) channels[LiveMesh.TANGENTS] = i;
        Channel[] sets = RenderMesh.textureSets(all);
        for (int s = 0; s < sets.length; s++)
            if (sets[s] != null) channels[LiveMesh.FIRST_SET + s] = all.indexOf(sets[s]);
        for (int a = 0; a < channels.length; a++)
            if (channels[a] != NONE)
                arrays[a] = new LiveArray(a == LiveMesh.COLOURS ? 1 : a == LiveMesh.TANGENTS ? 4 : 2);
    }

    boolean hasColours() {
        return channels[LiveMesh.COLOURS] != NONE;
    }

    /** Measures colours anew. True when all must be written again. */
    boolean isLightOther() {
        int colour = channels[LiveMesh.COLOURS];
        if (colour == NONE || ColourRange.isKnown(mesh.channels().get(colour).type())) return false;
        ColourRange range = new ColourRange();
        for (int w = 0; w < mesh.wedges(); w++) if (!mesh.isAbsent(colour, w)) range.add(mesh.values(colour, w), 0);
        double now = range.full(mesh.channels().get(colour).type());
        boolean isOther = now != full;
        full = now;
        return isOther;
    }

    /** Writes the attributes of a wedge to one of its render vertices. */
    void write(int wedge, int vertex) {
        for (int a = 0; a < channels.length; a++) {
            int channel = channels[a];
            if (channel == NONE) continue;
            boolean isAbsent = mesh.isAbsent(channel, wedge);
            Channel values = isAbsent ? null : mesh.values(channel, wedge);
            if (a == LiveMesh.COLOURS) {
                arrays[a].set(vertex, 0, isAbsent ? PackedColours.WHITE : PackedColours.of(values, 0, full));
            } else {
                for (int k = 0; k < arrays[a].width; k++) arrays[a].set(vertex, k, isAbsent ? 0f : values.number(0, k));
            }
        }
    }

    /** The slots all of whose corners have a tangent, ascending. */
    int[] slotsWithTangents(int slots, int[] groups) {
        int[] slotsWith = new int[slots];
        int count = 0;
        for (int g = 0; g < groups.length && arrays[LiveMesh.TANGENTS] != null; ) {
            int slot = groups[g];
            boolean hasAll = true;
            for (; g < groups.length && groups[g] == slot; g += 3)
                hasAll &= haveTangents(groups[g + 1], groups[g + 1] + groups[g + 2]);
            if (hasAll) slotsWith[count++] = slot;
        }
        return Arrays.copyOf(slotsWith, count);
    }

    private boolean haveTangents(int from, int to) {
        LiveArray tangents = arrays[LiveMesh.TANGENTS];
        for (int i = from; i < to; i++) {
            int vertex = arrays[LiveMesh.INDICES].get(i / 3, i % 3);
            boolean hasOne = tangents.number(vertex, 0) != 0
                    || tangents.number(vertex, 1) != 0
                    || tangents.number(vertex, 2) != 0;
            if (!hasOne) return false;
        }
        return true;
    }
}
