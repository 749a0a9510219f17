package org.jsmesh.encode;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.jsmesh.codec.connectivity.CodedMesh;
import org.jsmesh.collapse.CollapseMesh;
import org.jsmesh.collapse.Effort;
import org.jsmesh.collapse.QuadricSimplifier;
import org.jsmesh.collapse.SimplificationTarget;
import org.jsmesh.encode.measure.LevelMeter;
import org.jsmesh.encode.measure.StageProgress;
import org.jsmesh.encode.measure.SurfaceFit;
import org.jsmesh.encode.measure.SurfacePoints;
import org.jsmesh.encode.write.ArchiveWriter;
import org.jsmesh.encode.write.CoarseFit;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.ManifoldCut;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.patch.PatchLog;
import org.junit.jupiter.api.Test;

/** Meshes without neighbours are encoded without a table of their faces, to the same bytes as with one. */
class SeparateMeshTest {
    private static final int FACES = 400;

    @Test
    void shouldWriteASoupAsWithATable() {
        assertIsSame(soup(false), false);
    }

    @Test
    void shouldWriteABookAsWithATable() {
        assertIsSame(book(false), false);
    }

    @Test
    void shouldWriteColoursAsWithATable() {
        assertIsSame(soup(true), false);
        assertIsSame(book(true), true);
    }

    @Test
    void shouldKeepTheOrderAsWithATable() {
        assertIsSame(soup(false), true);
        assertIsSame(book(false), true);
    }

    private static void assertIsSame(Mesh mesh, boolean keepsOrder) {
        CollapseMesh separate = simplified(mesh);
        assertThat(separate.isSeparate()).isTrue();
        assertThat(separate.log().components()).isGreaterThan(FACES / 2);
        byte[] expected = write(new WithTable(simplified(mesh)), keepsOrder);
        assertThat(write(new SimplifiedMesh(separate, true), keepsOrder)).isEqualTo(expected);
    }

    private static CollapseMesh simplified(Mesh mesh) {
        CollapseMesh collapsing = new CollapseMesh(mesh);
        SimplificationTarget target = SimplificationTarget.ofFaces(30);
        QuadricSimplifier.simplify(collapsing, target, Effort.SOME, ProgressListener.NONE, Runnable::run, 1);
        return collapsing;
    }

    private static byte[] write(CodedMesh source, boolean keepsOrder) {
        Mesh mesh = source.original();
        SurfacePoints surface = new SurfacePoints(mesh.positions(), mesh.faceWedges());
        StageProgress stages = new StageProgress(ProgressListener.NONE);
        LevelMeter meter = new LevelMeter(mesh, mesh.faceWedges(), surface, stages);
        ArchiveWriter writer = new ArchiveWriter(source, meter);
        writer.fitCoarse(new SurfaceFit(mesh, surface, stages), CoarseFit.Effort.SOME);
        if (keepsOrder) writer.keepOrder(mesh);
        return new EncodedArchive(writer.write("0".repeat(64), (done, of) -> {}), null, List.of()).bytes();
    }

    /** The same mesh with a table that has dummy faces. */
    private static final class WithTable implements CodedMesh {
        private final CollapseMesh mesh;
        private final CornerTable table;

        WithTable(CollapseMesh mesh) {
            this.mesh = mesh;
            table = new ManifoldCut(mesh.original()).table();
            for (int v = 0; v < table.vertices(); v++) if (mesh.table().cornerOf(v) < 0) table.setCornerOf(v, -1);
        }

        @Override
        public Mesh original() {
            return mesh.original();
        }

        @Override
        public CornerTable table() {
            return table;
        }

        @Override
        public int[] vertexOf() {
            return mesh.vertexOf();
        }

        @Override
        public boolean isLiveFace(int face) {
            return mesh.isLiveFace(face);
        }

        @Override
        public int wedge(int corner) {
            return mesh.wedge(corner);
        }

        @Override
        public PatchLog log() {
            return mesh.log();
        }
    }

    /** Triangles about one edge. */
    private static Mesh book(boolean coloured) {
        int[] faces = new int[3 * FACES];
        for (int f = 0; f < FACES; f++) {
            faces[3 * f + 1] = 1;
            faces[3 * f + 2] = f + 2;
        }
        return mesh(FACES + 2, faces, coloured);
    }

    private static Mesh soup(boolean coloured) {
        int[] faces = new int[3 * FACES];
        Arrays.setAll(faces, i -> i);
        return mesh(faces.length, faces, coloured);
    }

    private static Mesh mesh(int vertices, int[] faces, boolean coloured) {
        Random random = new Random(vertices);
        float[] positions = new float[3 * vertices];
        for (int i = 0; i < positions.length; i++) positions[i] = random.nextFloat();
        MeshBuilder builder = new MeshBuilder().positions(positions).faceWedges(faces);
        if (coloured) {
            int[] values = random.ints(3 * vertices, 0, 256).toArray();
            builder.channels(
                    List.of(new Channel(Channel.Semantic.COLOUR, "colour", 3, Channel.Type.UINT8, values, null)));
        }
        return builder.build();
    }
}
