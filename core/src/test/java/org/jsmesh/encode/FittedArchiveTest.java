package org.jsmesh.encode;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.jsmesh.collapse.CollapseMesh;
import org.jsmesh.collapse.Effort;
import org.jsmesh.collapse.QuadricSimplifier;
import org.jsmesh.collapse.SimplificationTarget;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.measure.DistanceMeter;
import org.jsmesh.encode.measure.LevelMeter;
import org.jsmesh.encode.measure.StageProgress;
import org.jsmesh.encode.measure.SurfaceFit;
import org.jsmesh.encode.measure.SurfacePoints;
import org.jsmesh.encode.write.ArchiveWriter;
import org.jsmesh.encode.write.CoarseFit;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.ProgressListener;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Tag("slow")
class FittedArchiveTest {
    private static final int SIDE = 80;

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void shouldShowCoarseLevelsCloserToTheOriginal(boolean isSymmetric) throws Exception {
        Mesh torus = torus(isSymmetric);
        double plain = errorOfCoarseLevels(torus, write(torus, false));
        double fitted = errorOfCoarseLevels(torus, write(torus, true));
        assertThat(fitted).isLessThan(.85 * plain);
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void shouldBringAllVerticesBack(boolean isSymmetric) throws Exception {
        Mesh torus = torus(isSymmetric);
        byte[] archive = write(torus, true);
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(archive, 0, archive.length);
        assertThat(MeshIdentity.sha256(decoder.mesh())).isEqualTo(MeshIdentity.sha256(torus));
        assertThat(archive.length).isLessThan(write(torus, false).length * 104 / 100);
    }

    /** Geometric mean over the batches with up to a twelfth of the vertices. */
    private static double errorOfCoarseLevels(Mesh original, byte[] archive) throws Exception {
        DistanceMeter meter = new DistanceMeter(original);
        ArchiveDecoder decoder = new ArchiveDecoder();
        double logs = 0;
        int levels = 0;
        int seen = 0;
        for (int at = 0; decoder.batches() == 0 || 12 * decoder.mesh().vertices() < original.vertices(); at++) {
            decoder.feed(archive, at, 1);
            if (decoder.batches() == seen) continue;
            seen = decoder.batches();
            Mesh level = decoder.mesh();
            if (12 * level.vertices() > original.vertices()) break;
            int[] triangles = new int[3 * level.faces()];
            for (int i = 0; i < triangles.length; i++) triangles[i] = level.vertex(i / 3, i % 3);
            logs += Math.log(
                    meter.measure(level.positions(), triangles, level.faces()).mean());
            levels++;
        }
        assertThat(levels).isPositive();
        return Math.exp(logs / levels);
    }

    private static byte[] write(Mesh mesh, boolean fits) {
        CollapseMesh collapsing = new CollapseMesh(mesh);
        SimplificationTarget target = SimplificationTarget.ofVertices(60);
        QuadricSimplifier.simplify(collapsing, target, Effort.SOME, ProgressListener.NONE, Runnable::run, 1);
        SurfacePoints surface = new SurfacePoints(mesh.positions(), mesh.faceWedges());
        StageProgress stages = new StageProgress(ProgressListener.NONE);
        LevelMeter meter = new LevelMeter(mesh, mesh.faceWedges(), surface, stages);
        ArchiveWriter writer = new ArchiveWriter(new SimplifiedMesh(collapsing), meter);
        if (fits) writer.fitCoarse(new SurfaceFit(mesh, surface, stages), CoarseFit.Effort.SOME);
        return new EncodedArchive(writer.write(MeshIdentity.sha256(mesh), (done, of) -> {}), null, List.of()).bytes();
    }

    /** A torus with waves. */
    private static Mesh torus(boolean isSymmetric) {
        float[] positions = new float[3 * SIDE * SIDE];
        int[] corners = new int[6 * SIDE * SIDE];
        for (int i = 0; i < SIDE * SIDE; i++) {
            double u = 2 * Math.PI * (i / SIDE) / SIDE;
            double v = 2 * Math.PI * (i % SIDE) / SIDE;
            double skew = isSymmetric ? 0 : 1;
            double r = 1 + .1 * StrictMath.sin(3 * u + skew * 2 * v) + .07 * StrictMath.cos(5 * v + skew * u);
            positions[3 * i] = (float) ((3 + r * StrictMath.cos(v)) * StrictMath.cos(u));
            positions[3 * i + 1] = (float) ((3 + r * StrictMath.cos(v)) * StrictMath.sin(u));
            positions[3 * i + 2] = (float) (r * StrictMath.sin(v));
            int right = i / SIDE * SIDE + (i + 1) % SIDE;
            int down = (i + SIDE) % (SIDE * SIDE);
            int both = (right + SIDE) % (SIDE * SIDE);
            int at = 6 * i;
            for (int corner : new int[] {i, right, down, right, both, down}) corners[at++] = corner;
        }
        if (isSymmetric) // to the bit
        for (int i = 0; i < positions.length; i++) positions[i] = Math.round(positions[i] * 65536) / 65536f;
        return new MeshBuilder().positions(positions).faceWedges(corners).build();
    }
}
