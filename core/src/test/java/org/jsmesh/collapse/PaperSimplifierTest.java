package org.jsmesh.collapse;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshCleaner;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.VertexMerger;
import org.jsmesh.mesh.io.ModelReader;
import org.jsmesh.patch.PatchLog;
import org.jsmesh.test.CornerTableValidator;
import org.jsmesh.test.RandomMeshes;
import org.jsmesh.test.SampleModels;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PaperSimplifierTest {
    private static final List<Double> ALL = List.of(0.1, 0.5, 10.0);

    @ParameterizedTest
    @CsvSource({"fandisk.m, 1518, 761", "cessna.m, 5720, 2882"})
    void shouldReachTable1OfThePaper(String name, int faces, int vertices) throws IOException {
        Path file = SampleModels.other(name);
        Mesh mesh = ModelReader.read(name, Files.readAllBytes(file), path -> Optional.empty())
                .mesh();
        List<Note> notes = new ArrayList<>();
        CollapseMesh simplified = new CollapseMesh(VertexMerger.merge(MeshCleaner.clean(mesh, notes), notes));
        simplify(simplified, PaperSimplifier.DEFAULT_THRESHOLDS);
        assertThat((double) simplified.liveFaces()).isCloseTo(faces, within(.01 * faces));
        assertThat((double) liveVertices(simplified)).isCloseTo(vertices, within(.01 * vertices));
    }

    @Property(tries = 300, seed = "1")
    void shouldGiveBackTheOriginalWhenUndone(@ForAll RandomMeshes kind, @ForAll long seed) {
        CollapseMesh mesh = new CollapseMesh(kind.mesh(seed));
        PatchLog log = simplify(mesh, ALL);
        CornerTableValidator.validate(mesh.table());
        ReferenceUndo undo = new ReferenceUndo(mesh);
        for (int pass = log.passes() - 1; pass >= 0; pass--) {
            assertThat(log.passStart(pass + 1)).as("end of pass %d", pass).isGreaterThan(log.passStart(pass));
            if (pass > 0) assertThat(log.passLevel(pass)).isGreaterThanOrEqualTo(log.passLevel(pass - 1));
            undo.undoPass(pass);
        }
        undo.checkOriginal();
    }

    @Property(tries = 100, seed = "1")
    void shouldRemoveNoEndOfASharpEdge(@ForAll RandomMeshes kind, @ForAll long seed) {
        CollapseMesh mesh = new CollapseMesh(kind.mesh(seed));
        Set<Integer> corners = new HashSet<>();
        CornerTable t = mesh.table();
        for (int f = 0; f < mesh.original().faces(); f++) {
            for (int c = CornerTable.STRIDE * f; c < CornerTable.STRIDE * f + 3; c++) {
                if (!mesh.isSharp(c)) continue;
                corners.add(t.vertex(c));
                corners.add(t.vertex(CornerTable.previous(c)));
            }
        }
        PatchLog log = simplify(mesh, ALL);
        for (int p = 0; p < log.size(); p++) {
            assertThat(corners).doesNotContain(log.removed(p));
            assertThat(mesh.isCut(log.removed(p))).isFalse();
        }
    }

    @Test
    void shouldReduceABoxToTheVerticesOfItsEdges() {
        int n = 12;
        CollapseMesh mesh = new CollapseMesh(box(n));
        int vertices = liveVertices(mesh);
        assertThat(vertices).isEqualTo(6 * n * n + 2);
        PatchLog log = simplify(mesh, List.of(0.1));
        int onEdges = 12 * (n - 1) + 8; // they meet at 90 degrees, more than a crease needs
        assertThat(vertices - log.size()).isBetween(onEdges, onEdges + 6); // a last one on a side may have no way to go
        assertThat(mesh.liveFaces()).isEqualTo(2 * (vertices - log.size()) - 4);
    }

    @Test
    void shouldTakeFlatPartsAtTheFirstLevelAndBentOnesLater() {
        int n = 41;
        Mesh mesh = grid(n, x -> x <= n / 2 ? 0 : 0.04 * (x - n / 2) * (x - n / 2));
        PatchLog log = simplify(new CollapseMesh(mesh), List.of(0.001, 1.0));
        assertThat(log.levels()).isEqualTo(2);
        int bent = 0;
        for (int pass = 0; pass < log.passes(); pass++) {
            for (int p = log.passStart(pass); p < log.passStart(pass + 1); p++) {
                if (log.passLevel(pass) == 0) assertThat(log.removed(p) % n).isLessThan(n / 2);
                else if (log.removed(p) % n >= n / 2) bent++;
            }
        }
        assertThat(bent).isGreaterThan(n * n / 3);
        assertThat(log.threshold(0)).isEqualTo(0.001);
        assertThat(log.threshold(1)).isEqualTo(1.0);
    }

    @Test
    void shouldNeedFewPassesWhereAllWeightsAreEqual() {
        PatchLog log = simplify(new CollapseMesh(grid(100, x -> 0)), List.of(0.1));
        assertThat(log.size()).isGreaterThan(9000);
        assertThat(log.passes()).isLessThan(150);
    }

    @Test
    void shouldStopAtTheTarget() {
        CollapseMesh mesh = new CollapseMesh(grid(40, x -> 0.1 * Math.sin(x)));
        PaperSimplifier.simplify(mesh, ALL, SimplificationTarget.ofFaces(1500), ProgressListener.NONE);
        assertThat(mesh.liveFaces()).isBetween(1499, 1500);
    }

    @Test
    void shouldStopWhenCancelled() {
        ProgressListener impatient = new ProgressListener() {
            @Override
            public void progress(String stage, double fraction) {}

            @Override
            public boolean isCancelled() {
                return true;
            }
        };
        CollapseMesh mesh = new CollapseMesh(grid(10, x -> 0));
        assertThatThrownBy(() -> PaperSimplifier.simplify(mesh, ALL, SimplificationTarget.floor(), impatient))
                .isInstanceOf(CancellationException.class);
    }

    @Test
    void shouldReportProgressUpToTheEnd() {
        double[] last = {-1};
        CollapseMesh mesh = new CollapseMesh(grid(60, x -> Math.sin(0.2 * x)));
        PaperSimplifier.simplify(mesh, ALL, SimplificationTarget.floor(), (stage, fraction) -> {
            assertThat(fraction).isBetween(last[0], 1.0);
            last[0] = fraction;
        });
        assertThat(last[0]).isEqualTo(1);
    }

    private static PatchLog simplify(CollapseMesh mesh, List<Double> thresholds) {
        return PaperSimplifier.simplify(mesh, thresholds, SimplificationTarget.floor(), ProgressListener.NONE);
    }

    private static int liveVertices(CollapseMesh mesh) {
        Set<Integer> vertices = new HashSet<>();
        for (int v = 0; v < mesh.table().vertices(); v++)
            if (mesh.table().cornerOf(v) >= 0) vertices.add(mesh.vertexOf()[v]);
        return vertices.size();
    }

    private interface Height {
        double at(int x);
    }

    private static Mesh grid(int n, Height height) {
        Quads quads = new Quads();
        for (int y = 0; y + 1 < n; y++) {
            for (int x = 0; x + 1 < n; x++) quads.add(y * n + x, 1, n);
        }
        float[] positions = new float[3 * n * n];
        for (int v = 0; v < n * n; v++) {
            positions[3 * v] = v % n;
            positions[3 * v + 1] = v / n;
            positions[3 * v + 2] = (float) height.at(v % n);
        }
        return quads.mesh(positions);
    }

    /** A closed box of n by n squares on each side. */
    private static Mesh box(int n) {
        Quads quads = new Quads();
        List<Float> positions = new ArrayList<>();
        for (int axis = 0; axis < 3; axis++) {
            for (int side = 0; side < 2; side++) {
                int first = positions.size() / 3;
                for (int i = 0; i < (n + 1) * (n + 1); i++) {
                    float[] p = new float[3];
                    p[axis] = side * n;
                    p[(axis + 1) % 3] = side == 1 ? i % (n + 1) : i / (n + 1);
                    p[(axis + 2) % 3] = side == 1 ? i / (n + 1) : i % (n + 1);
                    for (float x : p) positions.add(x);
                }
                for (int i = 0; i < n * n; i++) quads.add(first + i / n * (n + 1) + i % n, 1, n + 1);
            }
        }
        float[] xyz = new float[positions.size()];
        for (int i = 0; i < xyz.length; i++) xyz[i] = positions.get(i);
        return VertexMerger.merge(quads.mesh(xyz), new ArrayList<>());
    }

    private static final class Quads {
        private final List<Integer> corners = new ArrayList<>();

        void add(int v, int right, int up) {
            for (int w : new int[] {v, v + right, v + right + up, v, v + right + up, v + up}) corners.add(w);
        }

        Mesh mesh(float[] positions) {
            return new MeshBuilder()
                    .positions(positions)
                    .faceWedges(corners.stream().mapToInt(i -> i).toArray())
                    .build();
        }
    }
}
