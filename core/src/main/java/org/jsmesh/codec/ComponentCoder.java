package org.jsmesh.codec;

import java.util.Arrays;
import org.jsmesh.codec.attribute.WedgeCoder;
import org.jsmesh.codec.connectivity.BaseCoder;
import org.jsmesh.codec.connectivity.ConnectivityCoder;
import org.jsmesh.codec.connectivity.EncoderTruth;
import org.jsmesh.codec.entropy.BatchStreams;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.IntegerModel;
import org.jsmesh.codec.lattice.CoarseBox;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.codec.position.PositionCoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.patch.PatchLog;

/**
 * Codes whole components, one after the other: those of the base, and others that come at the start of a pass.
 * {@link BaseCoder} codes their connectivity, parallelograms predict their positions, materials and wedges follow face
 * by face.
 */
final class ComponentCoder {
    private final LodMesh mesh;
    private final MeshFormat format;
    private final EncoderTruth truth; // encoder only
    private final ConnectivityCoder splits;
    private final PositionCoder positions;
    private final WedgeCoder wedges;
    private final ComponentSteps distances; // encoder only
    private final BaseCoder faces = new BaseCoder(this::codeVertex);
    private final int[] stitched = BinaryCoder.newContexts(1);
    private final int[] another = BinaryCoder.newContexts(2);
    private int[] lastWedge = new int[16];
    private BatchStreams streams;
    private boolean isLater; // than the base
    private int firstFan; // of the component, or of the base
    private int lastFirst = -1; // the first fan vertex of the last component that came later
    private int apart; // usual distance between later components, and between the first two vertices of one, in cells
    private int wide;
    private boolean mayCome; // another one, in this pass
    private int comeInPass;
    private int next; // component in the encoder's log
    private int behind; // the last one of the pass

    ComponentCoder(
            LodMesh mesh,
            MeshFormat format,
            EncoderTruth truth,
            ConnectivityCoder splits,
            PositionCoder positions,
            WedgeCoder wedges,
            SplitSteps steps) {
        this.mesh = mesh;
        this.format = format;
        this.truth = truth;
        this.splits = splits;
        this.positions = positions;
        this.wedges = wedges;
        distances = steps == null ? null : new ComponentSteps(mesh, steps);
    }

    /**
     * Codes the base.
     *
     * @param knownFaces faces of the base; these and the vertices are of use to a decoder
     */
    void codeBase(BatchStreams to, int knownFaces, int knownVertices) throws MalformedStreamException {
        streams = to;
        int faceCount = truth == null ? knownFaces : truth.baseFaces();
        int fans = truth == null ? knownVertices : truth.baseFans();
        if (format.hasStitches) fans = new IntegerModel(1).unsigned(streams.connectivity(), fans);
        faces.code(streams.connectivity(), truth, faceCount, fans);
        if (!mesh.isSeparate()) mesh.setTable(faces.table());
        finish(0);
        isLater = true;
        apart = format.box.halfSide() >> 1;
        wide = format.box.halfSide() >> 3;
    }

    /** A pass begins; the encoder names its number in the log. */
    void beginPass(int logPass) {
        mayCome = format.hasComponents;
        comeInPass = 0;
        if (truth == null) return;
        PatchLog log = truth.plan.log();
        next = log.componentStart(logPass);
        behind = log.componentStart(logPass + 1);
        distances.begin(behind - next);
    }

    /**
     * Codes whether another component comes before the splits of the pass, and if so, codes it.
     *
     * @param most faces that it may have
     */
    boolean codeAnother(BatchStreams to, int most) throws MalformedStreamException {
        if (!mayCome) return false;
        mayCome = to.connectivity().bit(another, Math.min(comeInPass++, 1), next < behind ? 1 : 0) != 0;
        if (!mayCome) {
            if (distances != null) distances.end();
            return false;
        }
        streams = to;
        firstFan = mesh.fans();
        int firstFace = mesh.allFaces();
        if (truth != null) truth.beginComponent(truth.plan.log().componentFace(next++));
        faces.codeOne(streams.connectivity(), truth, most);
        if (!mesh.isSeparate()) {
            mesh.reserveTable(firstFace + faces.allFaces());
            faces.appendTo(mesh.table());
            splits.addComponent(firstFan);
        }
        finish(firstFace);
        if (distances != null) distances.add(firstFan);
        return true;
    }

    private void finish(int firstFace) throws MalformedStreamException {
        mesh.countFaces(faces.faces());
        mesh.growWedges();
        if (truth != null) truth.numberDummies();
        if (!mesh.hasChannels && !mesh.hasMaterials) return;
        int fans = mesh.fans() - firstFan;
        if (fans > lastWedge.length) lastWedge = new int[2 * fans];
        Arrays.fill(lastWedge, 0, fans, -1);
        for (int f = firstFace; f < firstFace + faces.faces(); f++)
            wedges.codeBaseFace(streams.attributes(), f, lastWedge, firstFan);
    }

    /** Codes the vertex and the position of a fan vertex; a, b, c are corners of the face across the gate, or −1. */
    private void codeVertex(int number, int a, int b, int c) throws MalformedStreamException {
        BinaryCoder coder = streams.geometry();
        int fan = firstFan + number;
        int original = truth == null ? -1 : truth.originalVertex(fan);
        if (!codeStitch(coder, fan, original)) {
            int vertex = mesh.addVertex();
            mesh.addFan(vertex);
            if (truth != null) truth.codedAs(original, vertex);
            if (a >= 0) codeBeyond(coder, fan, 4 * (firstFan + a), 4 * (firstFan + b), 4 * (firstFan + c), original);
            else if (isLater) codeLater(coder, fan, number, original);
            else codeInBox(coder, fan, original);
        }
        if (isLater && number < 2) learn(fan, number);
    }

    private boolean codeStitch(BinaryCoder coder, int fan, int original) {
        if (!format.hasStitches || mesh.vertices() == 0) return false;
        int known = truth == null ? -1 : truth.codedVertex(original);
        if (coder.bit(stitched, 0, known >= 0 ? 1 : 0) == 0) return false;
        int vertex = coder.uniform(known, mesh.vertices());
        mesh.addFan(vertex);
        positions.copy(fan, vertex);
        return true;
    }

    /** Predicts by the parallelogram across a gate a-b. */
    private void codeBeyond(BinaryCoder coder, int fan, int a, int b, int c, int original)
            throws MalformedStreamException {
        int[] cells = mesh.places();
        double x = (double) cells[a] + cells[b] - cells[c];
        double y = (double) cells[a + 1] + cells[b + 1] - cells[c + 1];
        double z = (double) cells[a + 2] + cells[b + 2] - cells[c + 2];
        positions.codeNear(coder, fan, x, y, z, distance(a, b) >> 1, original);
    }

    private void codeInBox(BinaryCoder coder, int fan, int original) throws MalformedStreamException {
        CoarseBox box = format.box;
        positions.codeNear(coder, fan, box.middle(0), box.middle(1), box.middle(2), box.halfSide() >> 1, original);
    }

    /**
     * Codes one of the first three vertices of a component: the first near the first vertex of the component before,
     * the others near the first.
     */
    private void codeLater(BinaryCoder coder, int fan, int number, int original) throws MalformedStreamException {
        int near = number == 0 ? lastFirst : firstFan;
        if (near < 0) {
            codeInBox(coder, fan, original);
            return;
        }
        int[] cells = mesh.places();
        int at = 4 * near;
        positions.codeNear(coder, fan, cells[at], cells[at + 1], cells[at + 2], number == 0 ? apart : wide, original);
    }

    private void learn(int fan, int number) {
        if (number == 0) {
            if (lastFirst >= 0) apart += (distance(4 * lastFirst, 4 * fan) >> 2) - (apart >> 2);
            lastFirst = fan;
        } else {
            wide += (distance(4 * firstFan, 4 * fan) >> 2) - (wide >> 2);
        }
    }

    /** The largest difference along an axis. */
    private int distance(int a, int b) {
        int[] cells = mesh.places();
        int most = 0;
        for (int k = 0; k < 3; k++) most = Math.max(most, Math.abs(cells[a + k] - cells[b + k]));
        return most;
    }
}
