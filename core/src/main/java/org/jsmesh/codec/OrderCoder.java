package org.jsmesh.codec;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.IntegerModel;
import org.jsmesh.codec.lod.ChainedIds;
import org.jsmesh.codec.lod.VertexFaces;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshCorrespondence;
import org.jsmesh.mesh.Sizes;

/**
 * Codes the original's order of vertices, faces and corners, given the decoded mesh, and what no face refers to. So the
 * arrays come back as they were. The coder looks for each vertex among the neighbours of the one before, and for each
 * face among those around the one before.
 */
public final class OrderCoder {
    private static final int RANKS = 24;
    private final BinaryCoder coder;
    private final Mesh decoded;
    private final Mesh original; // encoder only
    private final MeshCorrespondence same;
    private final VertexFaces around;
    private final IntegerModel counts = new IntegerModel(1);
    private final IntegerModel jumps = new IntegerModel(2);
    private final int[] vertexRank = BinaryCoder.newContexts(RANKS);
    private final int[] faceRank = BinaryCoder.newContexts(RANKS);
    private final int[] unused = BinaryCoder.newContexts(1);
    private final int[] rotated = BinaryCoder.newContexts(2);
    private final int[] vertexGroup; // first decoded vertex at the same place
    private final boolean isDouble;
    private float[] positions; // where not double
    private double[] exactPositions; // where double
    private int[] faces; // decoded face of each original one
    private ChainedIds verticesAt; // original vertices by group

    private OrderCoder(BinaryCoder coder, Mesh decoded, Mesh original) {
        this.coder = coder;
        this.decoded = decoded;
        this.original = original;
        same = original == null ? null : new MeshCorrespondence(original, decoded);
        around = new VertexFaces(decoded);
        vertexGroup = MeshCorrespondence.alikeVertices(decoded);
        isDouble = decoded.isDouble();
    }

    /** Writes the order of a mesh that decodes as another one. */
    public static void write(BinaryCoder coder, Mesh decoded, Mesh original) {
        try {
            new OrderCoder(coder, decoded, original).code(0);
        } catch (MalformedStreamException e) {
            throw new IllegalStateException(e); // what the encoder itself counted is in range
        }
    }

    /**
     * Reads the mesh in its original order.
     *
     * @param bytes of the order; they limit the number of vertices that the order may claim
     */
    public static Mesh read(BinaryCoder coder, Mesh decoded, int bytes) throws MalformedStreamException {
        return new OrderCoder(coder, decoded, null).code(bytes);
    }

    private Mesh code(int bytes) throws MalformedStreamException {
        boolean write = coder.isEncoder();
        int vertices = counts.unsigned(coder, write ? original.vertices() : 0);
        int wedges = counts.unsigned(coder, write ? original.wedges() : 0);
        long most = 3L * decoded.faces() + bytes;
        if (!write && (vertices > most || wedges > most))
            throw new MalformedStreamException(-1, "an order of " + vertices + " vertices and " + wedges + " wedges");
        codeVertices(vertices);
        CornerOrderCoder corners =
                new CornerOrderCoder(coder, decoded, original, vertexGroup, verticesAt, vertices, wedges);
        int[] faceMaterials = codeFaces(corners);
        MeshBuilder builder = new MeshBuilder();
        if (isDouble) builder.positions(exactPositions);
        else builder.positions(positions);
        return builder.faceChannels(faceChannels())
                .wedgeVertices(corners.wedgeVertices())
                .faceWedges(corners.faceWedges())
                .faceMaterials(faceMaterials)
                .channels(corners.channels())
                .materials(decoded.materials())
                .textures(decoded.textures())
                .build();
    }

    private void codeVertices(int count) throws MalformedStreamException {
        int[] wanted = original == null ? null : references();
        positions = new float[isDouble ? 0 : 3 * count];
        exactPositions = new double[isDouble ? 3 * count : 0];
        verticesAt = new ChainedIds(decoded.vertices(), count);
        boolean[] used = new boolean[decoded.vertices()];
        int last = 0;
        for (int i = 0; i < count; i++) {
            if ((i & 15) == 0 && coder.isExhausted()) throw new MalformedStreamException(-1, "the order ends early");
            int target = wanted == null ? 0 : wanted[i];
            if (coder.bit(unused, 0, target < 0 ? 1 : 0) != 0) {
                codeUnused(i);
                continue;
            }
            int vertex = codeNeighbour(last, target, used);
            if (vertex < 0) {
                vertex = last + jumps.signed(coder, 0, target - last);
                if (vertex < 0 || vertex >= used.length)
                    throw new MalformedStreamException(-1, "the order names vertex " + vertex);
            }
            used[vertex] = true;
            last = vertex;
            for (int a = 0; isDouble && a < 3; a++) exactPositions[3 * i + a] = decoded.coordinate(vertex, a);
            if (!isDouble) System.arraycopy(decoded.positions(), 3 * vertex, positions, 3 * i, 3);
            verticesAt.add(vertexGroup[vertex], i);
        }
    }

    /** The decoded vertex of each original one, or −1 when no face uses it. */
    private int[] references() {
        int[] references = new int[original.vertices()];
        java.util.Arrays.fill(references, -1);
        for (int f = original.faces() - 1; f >= 0; f--) {
            for (int j = 0; j < 3; j++)
                references[original.vertex(f, j)] = decoded.vertex(same.face(f), (j + same.rotation(f)) % 3);
        }
        return references;
    }

    private void codeUnused(int i) throws MalformedStreamException {
        for (int a = 0; a < 3; a++) {
            if (isDouble) {
                exactPositions[3 * i + a] = codeUnusedDouble(original == null ? 0 : original.coordinate(i, a));
                continue;
            }
            int bits = coder.raw(original == null ? 0 : Float.floatToRawIntBits(original.positions()[3 * i + a]), 32);
            if ((bits & 0x7f800000) == 0x7f800000) throw new MalformedStreamException(-1, "a position is not finite");
            positions[3 * i + a] = Float.intBitsToFloat(bits);
        }
    }

    private double codeUnusedDouble(double wanted) throws MalformedStreamException {
        long bits = Double.doubleToRawLongBits(wanted);
        long low = coder.raw((int) bits, 32) & 0xffffffffL;
        double x = Double.longBitsToDouble((long) coder.raw((int) (bits >>> 32), 32) << 32 | low);
        if (Math.abs(x) <= Double.MAX_VALUE) return x;
        throw new MalformedStreamException(-1, "a position is not finite");
    }

    private List<FaceChannel> faceChannels() {
        List<FaceChannel> channels = new ArrayList<>();
        for (FaceChannel c : decoded.faceChannels()) {
            int words = c.words();
            int[] values = new int[Sizes.of(words, faces.length, "faces with " + c.name())];
            for (int f = 0; f < faces.length; f++)
                System.arraycopy(c.values(), words * faces[f], values, words * f, words);
            channels.add(c.withValues(values));
        }
        return channels;
    }

    /** Codes which of the unused neighbours of a vertex comes next; −1 when none does. */
    private int codeNeighbour(int last, int target, boolean[] used) {
        int rank = 0;
        for (int k = around.from(last); k < around.to(last); k++) {
            int f = around.face(k);
            for (int j = 0; j < 3; j++) {
                int v = decoded.vertex(f, j);
                int following = decoded.vertex(f, j == 2 ? 0 : j + 1);
                if (following != last || used[v]) continue; // each neighbour once: where the edge leads to the last
                if (coder.bit(vertexRank, Math.min(rank++, RANKS - 1), v == target ? 1 : 0) != 0) return v;
            }
        }
        return -1;
    }

    private int[] codeFaces(CornerOrderCoder corners) throws MalformedStreamException {
        int[] materials = new int[decoded.faces()];
        faces = new int[decoded.faces()];
        boolean[] used = new boolean[decoded.faces()];
        int last = 0;
        for (int f = 0; f < materials.length; f++) {
            if ((f & 15) == 0 && coder.isExhausted()) throw new MalformedStreamException(-1, "the order ends early");
            int target = same == null ? 0 : same.face(f);
            int face = codeNearFace(last, target, used);
            if (face < 0) {
                face = last + jumps.signed(coder, 1, target - last);
                if (face < 0 || face >= used.length || used[face])
                    throw new MalformedStreamException(-1, "the order names face " + face);
            }
            used[face] = true;
            last = face;
            materials[f] = decoded.faceMaterials()[face];
            faces[f] = face;
            corners.code(f, face, codeRotation(corners.smallest(face), same == null ? 0 : same.rotation(f)));
        }
        return materials;
    }

    private int codeNearFace(int last, int target, boolean[] used) {
        int rank = 0;
        for (int j = 0; j < 3; j++) {
            int v = decoded.vertex(last, j);
            for (int k = around.from(v); k < around.to(v); k++) {
                int f = around.face(k);
                if (used[f] || isSeen(f, last, j)) continue;
                if (coder.bit(faceRank, Math.min(rank++, RANKS - 1), f == target ? 1 : 0) != 0) return f;
            }
        }
        return -1;
    }

    /** Did a face come up at an earlier corner of the last one? */
    private boolean isSeen(int f, int last, int corner) {
        for (int j = 0; j < corner; j++) {
            for (int k = 0; k < 3; k++) if (decoded.vertex(f, k) == decoded.vertex(last, j)) return true;
        }
        return false;
    }

    /** Many files begin each face at its smallest vertex. */
    private int codeRotation(int smallest, int rotation) {
        int turned = (rotation - smallest + 3) % 3;
        if (coder.bit(rotated, 0, turned != 0 ? 1 : 0) == 0) return smallest;
        return (smallest + 1 + coder.bit(rotated, 1, turned == 2 ? 1 : 0)) % 3;
    }
}
