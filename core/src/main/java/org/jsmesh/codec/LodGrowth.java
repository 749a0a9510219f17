package org.jsmesh.codec;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import org.jsmesh.codec.attribute.ChannelFormat;
import org.jsmesh.codec.attribute.ChannelValues;
import org.jsmesh.codec.attribute.NormalSums;
import org.jsmesh.codec.exact.NumberForms;
import org.jsmesh.codec.lattice.Translation;
import org.jsmesh.codec.lod.LodChanges;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.GrowingMesh;

/** What a {@link LodMesh} shows, element by element, where {@link LodSnapshot} copies all of it. */
final class LodGrowth implements GrowingMesh {
    private final LodMesh mesh;
    private final LodChanges changes;
    private final SweepCoder sweeps;
    private final Translation translation;
    private final ChannelValues[] values;
    private final NumberForms forms;
    private final List<Channel> coded = new ArrayList<>(); // of one wedge
    private final List<Channel> shown = new ArrayList<>();
    private final NormalSums[] normals; // null for channels that do not come as sums of normals
    private final double[] xyz = new double[9];
    private int[] star = new int[64 * CORNER];
    private int[] sorted = new int[64]; // corners around a vertex by the arrival of their faces
    private int[] faces = new int[64]; // arrivals of these
    private final BitSet changed = new BitSet();
    private final BitSet reshaped = new BitSet();
    private int seenVertices;

    LodGrowth(LodMesh mesh, SweepCoder sweeps, Translation translation, ChannelValues[] values, NumberForms forms) {
        this.mesh = mesh;
        this.changes = mesh.noteChanges();
        this.sweeps = sweeps;
        this.translation = translation;
        this.values = values;
        this.forms = forms;
        normals = new NormalSums[values.length];
        for (int i = 0; i < values.length; i++) {
            ChannelFormat f = values[i].format;
            Channel one = new Channel(f.semantic(), f.name(), f.components(), f.type(), new int[f.components()], null);
            coded.add(one);
            shown.add(forms.shownWedge(one, i));
            if (f.normals() != null) normals[i] = NormalSums.ofOne(f.normals().weight());
        }
    }

    @Override
    public int vertices() {
        return mesh.vertices();
    }

    @Override
    public int wedges() {
        return mesh.wedges();
    }

    @Override
    public int faceNumbers() {
        return mesh.table().faces();
    }

    @Override
    public int faces() {
        return mesh.realFaces();
    }

    @Override
    public int[] shownFaces() {
        CornerTable t = mesh.table();
        int[] shown = new int[mesh.realFaces()];
        int n = 0;
        for (int f = 0; f < t.faces(); f++) if (!t.isDummy(f)) shown[n++] = changes.faceArrival(f);
        return shown;
    }

    @Override
    public List<Channel> channels() {
        return shown;
    }

    @Override
    public BitSet takeChanges() {
        reshaped.clear();
        reshaped.set(seenVertices, mesh.vertices());
        for (int fan = changes.firstNew(); fan < mesh.fans(); fan++) markAround(changes.vertex(fan), reshaped);
        BitSet wedges = changes.wedges();
        for (int w = wedges.nextSetBit(0); w >= 0; w = wedges.nextSetBit(w + 1))
            reshaped.set(changes.vertexArrival(mesh.wedgeVertex(w)));
        changed.clear();
        changed.or(reshaped);
        BitSet moved = changes.moved();
        if (moved.cardinality() >= seenVertices) changed.set(0, mesh.vertices());
        else markAroundMoved(moved);
        changes.settle(mesh.fans());
        seenVertices = mesh.vertices();
        return changed;
    }

    private void markAroundMoved(BitSet moved) {
        for (int v = moved.nextSetBit(0); v >= 0; v = moved.nextSetBit(v + 1)) {
            int fan = mesh.firstFan(changes.vertex(v));
            do {
                markAround(fan, changed);
                fan = mesh.nextFan(fan);
            } while (fan != 0);
        }
    }

    /** Marks the vertices of all faces of a fan vertex, also of dummy ones: these tell which vertex lost a face. */
    private void markAround(int fan, BitSet marked) {
        CornerTable t = mesh.table();
        int start = t.cornerOf(fan);
        if (start < 0) return;
        int c = start;
        do {
            int first = CornerTable.STRIDE * CornerTable.face(c);
            for (int corner = first; corner < first + 3; corner++) {
                int v = t.vertex(corner);
                if (v != CornerTable.OUTSIDE) marked.set(changes.vertexArrival(mesh.vertexOf(v)));
            }
            c = t.swing(c);
        } while (c != start);
    }

    @Override
    public boolean isReshaped(int vertex) {
        return reshaped.get(vertex);
    }

    @Override
    public int vertexAt(int place) {
        return changes.vertexArrival(place);
    }

    @Override
    public int parent(int vertex) {
        int fan = mesh.firstFan(changes.vertex(vertex));
        int parent = changes.parent(changes.vertexArrival(fan));
        return parent < 0 ? -1 : changes.vertexArrival(mesh.vertexOf(changes.vertex(parent)));
    }

    @Override
    public float coordinate(int vertex, int axis) {
        return Float.intBitsToFloat(translation.moved(axis, sweeps.shownBits(changes.vertex(vertex), axis)));
    }

    @Override
    public int corners(int vertex, int[] corners) {
        CornerTable t = mesh.table();
        int n = 0;
        int fan = mesh.firstFan(changes.vertex(vertex));
        do {
            int start = t.cornerOf(fan);
            int c = start;
            while (c >= 0) {
                if (!t.isDummy(CornerTable.face(c))) sortIn(c, n++);
                c = t.swing(c);
                if (c == start) break;
            }
            fan = mesh.nextFan(fan);
        } while (fan != 0);
        if (CORNER * n <= corners.length) for (int i = 0; i < n; i++) put(i, corners);
        return n;
    }

    /** Puts a corner behind those of earlier faces, of which there are {@code n}. */
    private void sortIn(int c, int n) {
        if (n == sorted.length) {
            sorted = Arrays.copyOf(sorted, 2 * n);
            faces = Arrays.copyOf(faces, 2 * n);
        }
        int face = changes.faceArrival(CornerTable.face(c));
        int at = n;
        for (; at > 0 && faces[at - 1] > face; at--) {
            faces[at] = faces[at - 1];
            sorted[at] = sorted[at - 1];
        }
        faces[at] = face;
        sorted[at] = c;
    }

    private void put(int i, int[] corners) {
        int c = sorted[i];
        int at = CORNER * i;
        corners[at] = faces[i];
        corners[at + 1] = c & 3;
        corners[at + 2] = mesh.hasChannels ? mesh.wedge(c) : arrival(c);
        corners[at + 3] = arrival(CornerTable.next(c));
        corners[at + 4] = arrival(CornerTable.previous(c));
        corners[at + 5] = mesh.material(CornerTable.face(c));
    }

    /** The vertex of a corner. */
    private int arrival(int corner) {
        return changes.vertexArrival(mesh.vertexOf(mesh.table().vertex(corner)));
    }

    @Override
    public boolean isAbsent(int channel, int wedge) {
        return values[channel].isAbsent(wedge);
    }

    @Override
    public Channel values(int channel, int wedge) {
        Channel one = coded.get(channel);
        if (values[channel].isToCome(wedge)) sumNormals(normals[channel], wedge, one.values());
        else values[channel].copy(wedge, one.values());
        forms.show(one, shown.get(channel), channel);
        return shown.get(channel);
    }

    private void sumNormals(NormalSums sums, int wedge, int[] to) {
        int vertex = changes.vertexArrival(mesh.wedgeVertex(wedge));
        int n = corners(vertex, star);
        if (CORNER * n > star.length) {
            star = new int[CORNER * n];
            corners(vertex, star);
        }
        sums.clear();
        for (int i = 0; i < CORNER * n; i += CORNER) {
            if (star[i + 2] != wedge) continue;
            int place = star[i + 1];
            put(vertex, place);
            put(star[i + 3], (place + 1) % 3);
            put(star[i + 4], (place + 2) % 3);
            sums.add(xyz, 1 << place);
        }
        sums.put(to);
    }

    private void put(int vertex, int place) {
        for (int a = 0; a < 3; a++) xyz[3 * place + a] = coordinate(vertex, a);
    }
}
