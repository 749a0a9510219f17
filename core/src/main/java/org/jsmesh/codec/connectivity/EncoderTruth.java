package org.jsmesh.codec.connectivity;

import java.util.Arrays;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.patch.PatchLog;

/** Answers the coders' questions from the simplified mesh, translating between its ids and the {@link LodMesh}'s. */
public final class EncoderTruth implements BaseTruth, WedgeTruth {
    public final PatchPlan plan;
    private final CodedMesh source;
    private final int[] vertexOf; // null without stitches, when fan vertices are the original's vertices
    private final LodMesh mesh;
    private final int baseFaces;
    private final int baseFans;
    private int seed;
    private int firstFan; // of the component that is being coded, or of the base
    private int firstFace;
    private int[] oldFaces = new int[64]; // of its faces
    private int[] firstCorner = new int[64]; // of its faces: the original's corner that comes first
    private int[] oldWedge = new int[64];
    private int coded;
    private final int[] codedVertex; // of the original's vertices; empty without stitches

    public EncoderTruth(CodedMesh source, LodMesh mesh) {
        this.source = source;
        vertexOf = source.vertexOf().length > source.original().vertices() ? source.vertexOf() : null;
        this.mesh = mesh;
        CornerTable t = source.table();
        int codedFaces = mesh.hasChannels || mesh.hasMaterials ? mesh.expectedFaces() : 0;
        plan = new PatchPlan(source.log(), t.vertices(), !source.isSeparate(), t.faces(), codedFaces);
        int faces = 0;
        for (int f = 0; f < t.faces(); f++) if (source.isLiveFace(f)) faces++;
        baseFaces = faces;
        int fans = 0;
        for (int v = 0; v < t.vertices(); v++) if (t.cornerOf(v) >= 0) fans++;
        baseFans = fans;
        codedVertex = new int[vertexOf == null ? 0 : source.original().vertices()];
        Arrays.fill(codedVertex, -1);
    }

    public int baseFaces() {
        return baseFaces;
    }

    public int baseFans() {
        return baseFans;
    }

    /** The original's mesh vertex of a coded fan vertex. */
    public int originalVertex(int fan) {
        int old = plan.oldVertex(fan);
        return vertexOf == null ? old : vertexOf[old];
    }

    /** The original's vertex of a coded mesh vertex. */
    public int originalOf(int vertex) {
        return originalVertex(mesh.firstFan(vertex));
    }

    /** The coded face of an original one. */
    public int codedFace(int original) {
        return plan.newFace(original);
    }

    /** The coded mesh vertex of an original one, or −1 if there is none yet. Only where there are stitches. */
    public int codedVertex(int original) {
        return codedVertex[original];
    }

    public void codedAs(int original, int vertex) {
        if (codedVertex.length > 0) codedVertex[original] = vertex;
    }

    /** Has a pass of the log patches, and not only components? */
    public boolean hasSplits(int pass) {
        return plan.log().passStart(pass) < plan.log().passStart(pass + 1);
    }

    /** Goes on to a component that comes later, given the original's number of one of its faces. */
    public void beginComponent(int face) {
        seed = face;
        firstFan = mesh.fans();
        firstFace = mesh.allFaces();
        coded = 0;
    }

    @Override
    public int nextComponent() {
        while (firstFan == 0 && (!source.isLiveFace(seed) || plan.newFace(seed) >= 0)) seed++;
        return seed;
    }

    private static int wide(int face, int corner) {
        return CornerTable.STRIDE * face + corner;
    }

    @Override
    public int across(int gate) {
        if (source.isSeparate()) return -1;
        int corner = wide(oldFaces[gate / 3], (firstCorner[gate / 3] + gate % 3) % 3);
        // the edge leads from this corner to the next; swinging about its end crosses it
        int behind = source.table().swing(CornerTable.next(corner));
        int face = CornerTable.face(behind);
        return source.table().isDummy(face) ? -1 : 3 * face + (behind & 3);
    }

    @Override
    public int fanAt(int face, int corner) {
        int fan = plan.newVertex(source.fan(face, corner));
        return fan < 0 ? fan : fan - firstFan;
    }

    @Override
    public void numberFan(int face, int corner, int fan) {
        plan.number(source.fan(face, corner), firstFan + fan);
    }

    @Override
    public void numberFace(int face, int first, int newFace) {
        if (newFace == firstCorner.length) {
            firstCorner = Arrays.copyOf(firstCorner, 2 * newFace);
            oldFaces = Arrays.copyOf(oldFaces, 2 * newFace);
        }
        firstCorner[newFace] = first;
        oldFaces[newFace] = face;
        plan.numberFace(face, firstFace + newFace);
        coded++;
    }

    /** Numbers the dummy faces after the coder has built the table: they are found behind the same edges. */
    public void numberDummies() {
        if (source.isSeparate()) return; // no patch will ask for them
        CornerTable t = source.table();
        for (int gate = 0; gate < 3 * coded; gate++) {
            int oldCorner = wide(oldFaces[gate / 3], (firstCorner[gate / 3] + gate % 3) % 3);
            int oldBehind = CornerTable.face(t.swing(CornerTable.next(oldCorner)));
            if (!t.isDummy(oldBehind)) continue;
            int newBehind =
                    CornerTable.face(mesh.table().swing(CornerTable.next(wide(firstFace + gate / 3, gate % 3))));
            plan.numberFace(oldBehind, newBehind);
        }
    }

    @Override
    public int wedge(int corner) {
        int old = plan.oldFace(CornerTable.face(corner));
        int vertex = plan.oldVertex(mesh.table().vertex(corner));
        int[] data = source.table().data();
        int at = CornerTable.STRIDE * old;
        int j = data[at + 1] == vertex
                ? 1
                : data[at + 2] == vertex ? 2 : 0; // corner 0 of a removed face is overwritten
        return source.wedge(at + j);
    }

    @Override
    public int runWedge(int patch, int i) {
        return plan.log().runWedge(patch, i);
    }

    @Override
    public int material(int face) {
        return source.original().faceMaterials()[plan.oldFace(face)];
    }

    @Override
    public boolean is(int wedge, int originalWedge) {
        return oldWedge[wedge] == originalWedge;
    }

    /** The original's wedge of a coded one. */
    public int originalWedge(int wedge) {
        return oldWedge[wedge];
    }

    @Override
    public void number(int originalWedge, int wedge) {
        if (wedge >= oldWedge.length) oldWedge = Arrays.copyOf(oldWedge, 2 * wedge);
        oldWedge[wedge] = originalWedge;
    }

    PatchLog log() {
        return plan.log();
    }
}
