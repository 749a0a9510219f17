package org.jsmesh.codec;

import java.util.List;
import org.jsmesh.codec.attribute.ByteRefiner;
import org.jsmesh.codec.attribute.ChannelCoder;
import org.jsmesh.codec.attribute.ChannelDetector;
import org.jsmesh.codec.attribute.ChannelFormat;
import org.jsmesh.codec.attribute.ChannelRefiner;
import org.jsmesh.codec.attribute.ChannelValues;
import org.jsmesh.codec.attribute.NormalRefiner;
import org.jsmesh.codec.attribute.StagedRefiner;
import org.jsmesh.codec.attribute.WedgeCoder;
import org.jsmesh.codec.connectivity.CodedMesh;
import org.jsmesh.codec.connectivity.EncoderTruth;
import org.jsmesh.codec.connectivity.PairRunner;
import org.jsmesh.codec.entropy.BatchStreams;
import org.jsmesh.codec.exact.NumberForms;
import org.jsmesh.codec.exact.RemainderCoder;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.codec.lod.LodSurface;
import org.jsmesh.codec.position.PositionCoder;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.GrowingMesh;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.Sizes;
import org.jsmesh.mesh.Texture;

/**
 * Codes a mesh in both directions: the base, then pass after pass of vertex splits. Connectivity, geometry and
 * attributes go through a coder each ({@link BatchStreams}), so that a batch holds them one after the other. Contexts
 * live as long as this object.
 */
public final class MeshCoder {
    /** A triangle without neighbours, and its open edges. */
    private static final int SEPARATE = 4;

    private final MeshFormat format;
    private final LodMesh mesh;
    private final EncoderTruth truth; // encoder only
    private final ChannelValues[] values;
    private final SplitSteps steps; // encoder only
    private final SplitCoder splits;
    private final SweepCoder sweeps;

    /**
     * @param truth null for a decoder, which has neither it nor the rest of what an encoder knows
     * @param exact positions of the original, or null
     * @param originals channels of the original, or null each
     */
    private MeshCoder(
            MeshFormat format,
            LodMesh mesh,
            EncoderTruth truth,
            SplitSteps steps,
            float[] exact,
            Channel[] originals,
            int faces) {
        this.format = format;
        this.mesh = mesh;
        this.truth = truth;
        this.steps = steps;
        PositionCoder positions = new PositionCoder(mesh, format.positions, format.mirror, format.isDense, exact);
        int n = format.channels.size();
        ChannelCoder[] channels = new ChannelCoder[n];
        values = new ChannelValues[n];
        ChannelRefiner[] refiners = new ChannelRefiner[n];
        for (int i = 0; i < n; i++) {
            ChannelFormat channel = format.channels.get(i);
            values[i] = new ChannelValues(channel);
            channels[i] = new ChannelCoder(values[i], originals[i]);
            if (channel.normals() != null) refiners[i] = new NormalRefiner(values[i], originals[i]);
            else if (channel.lattice() == null && channel.isRefined())
                refiners[i] = new ByteRefiner(values[i], originals[i]);
            else if (channel.isRefined()) refiners[i] = new StagedRefiner(values[i], originals[i]);
        }
        WedgeCoder wedges = new WedgeCoder(mesh, channels, format.materials, truth);
        splits = new SplitCoder(mesh, format, truth, positions, wedges, steps, faces);
        sweeps = new SweepCoder(mesh, format, truth, positions, values, refiners);
    }

    private static LodMesh mesh(MeshFormat format, int vertices, int fans, int faces) {
        boolean hasChannels = !format.channels.isEmpty();
        return new LodMesh(hasChannels, format.materials > 0, format.hasStitches, vertices, fans, faces);
    }

    /** A decoder of a mesh whose header claims so many vertices and faces. */
    public static MeshCoder decoder(MeshFormat format, int vertices, int faces) {
        Channel[] unknown = new Channel[format.channels.size()];
        return new MeshCoder(format, mesh(format, vertices, vertices, faces), null, null, null, unknown, faces);
    }

    public static MeshCoder encoder(MeshFormat format, CodedMesh source) {
        Mesh original = source.original();
        CornerTable table = source.table();
        int faces = source.isSeparate() ? Sizes.of(SEPARATE, table.faces(), "faces and open edges") : table.faces();
        LodMesh mesh = mesh(format, original.vertices(), table.vertices(), faces);
        if (source.isSeparate() && !mesh.hasChannels && !mesh.hasMaterials) mesh.setSeparate();
        Channel[] originals = new Channel[format.channels.size()];
        for (int i = 0; i < originals.length; i++)
            originals[i] = ChannelDetector.coded(
                    format.channels.get(i), original.channels().get(i));
        return new MeshCoder(
                format,
                mesh,
                new EncoderTruth(source, mesh),
                new SplitSteps(mesh),
                format.codedPositions(original),
                originals,
                original.faces());
    }

    /** Makes an encoder code connectivity and positions at the same time. The bytes are the same. */
    public void useHelper(PairRunner beside) {
        splits.useHelper(beside);
    }

    /** True when batches have an attribute part. */
    public boolean hasAttributes() {
        return mesh.hasChannels || mesh.hasMaterials;
    }

    /** Faces shown now. */
    public int faces() {
        return mesh.realFaces();
    }

    /** Vertices shown now. */
    public int vertices() {
        return mesh.vertices();
    }

    /**
     * Codes the base.
     *
     * @param knownFaces faces of the base; these and the vertices are of use to a decoder
     */
    public void codeBase(BatchStreams streams, int knownFaces, int knownVertices) throws MalformedStreamException {
        splits.codeBase(streams, knownFaces, knownVertices);
    }

    /** Sets the most faces that the mesh has before the next call. A decoder refuses more. */
    public void expectFaces(int most) {
        splits.expectFaces(most);
    }

    /** Starts the next pass; the encoder names its number in the log. */
    public void beginPass(int logPass) {
        splits.beginPass(logPass);
    }

    /**
     * Codes and applies the next steps of a pass: components, then vertex splits. A decoder stops early when its
     * streams end.
     */
    public void codeSplits(BatchStreams streams, int number) throws MalformedStreamException {
        splits.code(streams, number);
    }

    /** The sweeps over the present mesh, and the precision of positions. */
    public SweepCoder sweeps() {
        return sweeps;
    }

    /** The encoder's surface with exact positions; its vertices are those of the original. */
    public LodSurface exactSurface(Mesh original) {
        int[] corners = LodSurface.corners(mesh);
        for (int i = 0; i < corners.length; i++) corners[i] = truth.originalVertex(corners[i]);
        return new LodSurface(original.positions(), corners);
    }

    /** The surface as it is shown now. */
    public LodSurface surface() {
        return LodSurface.shown(mesh, format.cellSize(), format.translation, sweeps.exactVertices());
    }

    /** A coordinate of a vertex of the {@link #surface} as it is shown now. */
    public double coordinate(int vertex, int axis) {
        if (vertex < sweeps.exactVertices())
            return Float.intBitsToFloat(format.translation.moved(axis, mesh.positionBits()[3 * vertex + axis]));
        int cell = mesh.places()[4 * mesh.firstFan(vertex) + axis];
        return format.cellSize() * cell + format.translation.offset(axis);
    }

    /**
     * The largest distance by which splits since the last call have moved the surface at their vertices; in cells, as
     * it is shown.
     */
    public double largestStep() {
        double largest = steps.largest();
        steps.forget();
        return largest;
    }

    /** Which elements of the original those of a {@link #snapshot} are, for an encoder that has coded all. */
    public RemainderCoder.CodedIds ids() {
        int[] vertexIds = new int[mesh.vertices()];
        for (int v = 0; v < vertexIds.length; v++) vertexIds[v] = truth.originalOf(v);
        int[] wedgeIds = vertexIds;
        if (mesh.hasChannels) {
            wedgeIds = new int[mesh.wedges()];
            for (int w = 0; w < wedgeIds.length; w++) wedgeIds[w] = truth.originalWedge(w);
        }
        int[] atTable = new int[mesh.allFaces()];
        for (int f = 0; f < mesh.realFaces(); f++) atTable[truth.codedFace(f)] = f;
        int[] faceIds = new int[mesh.realFaces()];
        int n = 0;
        for (int f = 0; f < atTable.length; f++)
            if (mesh.isSeparate() || !mesh.table().isDummy(f)) faceIds[n++] = atTable[f];
        return new RemainderCoder.CodedIds(vertexIds, wedgeIds, faceIds);
    }

    /**
     * Lets somebody follow what a decoder shows; to be called before the base.
     *
     * @param forms of numbers that the codec does not know
     */
    public GrowingMesh growing(NumberForms forms) {
        return new LodGrowth(mesh, sweeps, format.translation, values, forms);
    }

    /** The mesh as it is shown now. */
    public Mesh snapshot(List<Material> materials, List<Texture> textures, List<Picture> previews) {
        sweeps.show();
        return LodSnapshot.of(mesh, format.translation, values)
                .materials(materials)
                .textures(textures)
                .previews(previews)
                .build();
    }
}
