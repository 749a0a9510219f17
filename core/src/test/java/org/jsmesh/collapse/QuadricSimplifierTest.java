package org.jsmesh.collapse;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.patch.PatchLog;
import org.jsmesh.test.CornerTableValidator;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;

class QuadricSimplifierTest {
    @Property(tries = 300, seed = "1")
    void shouldGiveBackTheOriginalWhenUndone(@ForAll RandomMeshes kind, @ForAll long seed) {
        CollapseMesh mesh = new CollapseMesh(kind.mesh(seed));
        PatchLog log =
                QuadricSimplifier.simplify(mesh, SimplificationTarget.floor(), Effort.SOME, ProgressListener.NONE);
        // The table of a soup has no faces outside.
        if (!mesh.isSeparate()) CornerTableValidator.validate(mesh.table());
        ReferenceUndo undo = new ReferenceUndo(mesh);
        for (int pass = log.passes() - 1; pass >= 0; pass--) {
            assertThat(log.steps(pass)).as("steps of pass %d", pass).isPositive();
            undo.undoPass(pass);
        }
        undo.checkOriginal();
    }

    /** Three sheets that share a border: every edge of it has three faces. */
    @Test
    void shouldSimplifySheetsThatMeetAlongABorder() {
        CollapseMesh mesh = new CollapseMesh(RandomMeshes.book(20, 3));
        PatchLog log =
                QuadricSimplifier.simplify(mesh, SimplificationTarget.floor(), Effort.SOME, ProgressListener.NONE);
        int cut = 0;
        for (int p = 0; p < log.size(); p++) if (mesh.isCut(log.removed(p))) cut++;
        assertThat(cut).isGreaterThan(30);
        assertThat(mesh.liveFaces()).isLessThan(30);
    }

    @Test
    void shouldDoTheSameWithAnyNumberOfThreads() {
        ExecutorService executor = Executors.newFixedThreadPool(3);
        try {
            Mesh bumps = bumps(90);
            CollapseMesh alone = new CollapseMesh(bumps);
            PatchLog expected =
                    QuadricSimplifier.simplify(alone, SimplificationTarget.floor(), Effort.SOME, ProgressListener.NONE);
            for (int threads = 2; threads <= 4; threads++) {
                CollapseMesh mesh = new CollapseMesh(bumps);
                PatchLog log = QuadricSimplifier.simplify(
                        mesh, SimplificationTarget.floor(), Effort.SOME, ProgressListener.NONE, executor, threads);
                assertThat(describe(log)).isEqualTo(describe(expected));
            }
        } finally {
            executor.shutdown();
        }
    }

    @Test
    void shouldStopAtTheTarget() {
        CollapseMesh faces = new CollapseMesh(bumps(30));
        QuadricSimplifier.simplify(faces, SimplificationTarget.ofFaces(500), Effort.SOME, ProgressListener.NONE);
        assertThat(faces.liveFaces()).isBetween(499, 500);

        CollapseMesh vertices = new CollapseMesh(bumps(30));
        PatchLog log = QuadricSimplifier.simplify(
                vertices, SimplificationTarget.ofVertices(400), Effort.SOME, ProgressListener.NONE);
        assertThat(900 - log.size()).isEqualTo(400);

        CollapseMesh reached = new CollapseMesh(bumps(30));
        assertThat(QuadricSimplifier.simplify(
                                reached, SimplificationTarget.ofVertices(1000), Effort.SOME, ProgressListener.NONE)
                        .passes())
                .isZero();
    }

    @Test
    void shouldGoDownToAHandfulOfVertices() {
        CollapseMesh mesh = new CollapseMesh(RandomMeshes.TORUS.mesh(3));
        int before = mesh.table().vertices();
        PatchLog log =
                QuadricSimplifier.simplify(mesh, SimplificationTarget.floor(), Effort.SOME, ProgressListener.NONE);
        assertThat(before - log.size()).isLessThan(20);
        assertThat(mesh.liveFaces()).isGreaterThanOrEqualTo(14); // the smallest torus
    }

    @Test
    void shouldTakeTheCheapestPlacesFirst() {
        // one half flat, the other rough: the flat half goes first
        int n = 40;
        Mesh mesh = grid(n, (x, y) -> x < n / 2 ? 0 : 0.3 * Math.sin(2.1 * x) * Math.cos(1.7 * y));
        CollapseMesh collapse = new CollapseMesh(mesh);
        PatchLog log = QuadricSimplifier.simplify(
                collapse, SimplificationTarget.ofVertices(n * n - 500), Effort.SOME, ProgressListener.NONE);
        for (int p = 0; p < log.size(); p++) assertThat(log.removed(p) % n).isLessThanOrEqualTo(n / 2);
    }

    @Test
    void shouldKeepAFoldedFin() {
        // a flat sheet of no thickness, closed over its rim: every plane is the same, and only the rim holds the shape
        int n = 12;
        Mesh front = grid(n, (x, y) -> 0);
        int[] faces = front.faceWedges();
        int[] both = Arrays.copyOf(faces, 2 * faces.length);
        int[] back = new int[n * n];
        float[] positions = Arrays.copyOf(front.positions(), 6 * n * n);
        for (int v = 0; v < n * n; v++) {
            boolean rim = v % n == 0 || v % n == n - 1 || v / n == 0 || v / n == n - 1;
            back[v] = rim ? v : n * n + v;
            System.arraycopy(positions, 3 * v, positions, 3 * (n * n + v), 3);
        }
        for (int i = 0; i < faces.length; i += 3) {
            both[faces.length + i] = back[faces[i]];
            both[faces.length + i + 1] = back[faces[i + 2]];
            both[faces.length + i + 2] = back[faces[i + 1]];
        }
        CollapseMesh mesh = new CollapseMesh(
                new MeshBuilder().positions(positions).faceWedges(both).build());
        PatchLog log = QuadricSimplifier.simplify(
                mesh, SimplificationTarget.ofVertices(30), Effort.SOME, ProgressListener.NONE);
        int[] corners = {0, n - 1, n * (n - 1), n * n - 1};
        for (int p = 0; p < log.size(); p++) assertThat(corners).doesNotContain(log.removed(p));
    }

    @Test
    void shouldRaiseThresholdsFromLevelToLevel() {
        PatchLog log = QuadricSimplifier.simplify(
                new CollapseMesh(bumps(40)), SimplificationTarget.floor(), Effort.SOME, ProgressListener.NONE);
        assertThat(log.levels()).isGreaterThan(2);
        for (int i = 1; i < log.levels(); i++) assertThat(log.threshold(i)).isGreaterThan(log.threshold(i - 1));
        for (int i = 1; i < log.passes(); i++)
            assertThat(log.passLevel(i)).isBetween(log.passLevel(i - 1), log.levels() - 1);
    }

    @Test
    void shouldStopWhenCancelled() {
        ProgressListener impatient = new ProgressListener() {
            private boolean cancelled;

            @Override
            public void progress(String stage, double fraction) {
                cancelled |= fraction > 0.3;
            }

            @Override
            public boolean isCancelled() {
                return cancelled;
            }
        };
        CollapseMesh mesh = new CollapseMesh(bumps(40));
        assertThatThrownBy(() -> QuadricSimplifier.simplify(mesh, SimplificationTarget.floor(), Effort.SOME, impatient))
                .isInstanceOf(CancellationException.class);
        assertThat(mesh.log().size()).isBetween(1, 1500);
    }

    @Test
    void shouldReportProgressUpToTheEnd() {
        double[] last = {-1};
        QuadricSimplifier.simplify(
                new CollapseMesh(bumps(30)), SimplificationTarget.ofFaces(200), Effort.SOME, (stage, fraction) -> {
                    assertThat(fraction).isBetween(last[0], 1.0);
                    last[0] = fraction;
                });
        assertThat(last[0]).isEqualTo(1);
    }

    private static String describe(PatchLog log) {
        StringBuilder s = new StringBuilder();
        for (int p = 0; p < log.size(); p++) {
            s.append(log.removed(p))
                    .append('>')
                    .append(log.kept(p))
                    .append(':')
                    .append(log.runFace(p))
                    .append(' ');
        }
        for (int i = 0; i < log.passes(); i++) s.append(log.passStart(i)).append(' ');
        return s.toString();
    }

    private static Mesh bumps(int n) {
        return grid(n, (x, y) -> Math.sin(0.31 * x) + Math.cos(0.23 * y) + 0.02 * Math.sin(12.9898 * x + 78.233 * y));
    }

    private interface Height {
        double at(int x, int y);
    }

    private static Mesh grid(int n, Height height) {
        float[] positions = new float[3 * n * n];
        int[] faces = new int[6 * (n - 1) * (n - 1)];
        int at = 0;
        for (int y = 0; y < n; y++) {
            for (int x = 0; x < n; x++) {
                int v = y * n + x;
                positions[3 * v] = x;
                positions[3 * v + 1] = y;
                positions[3 * v + 2] = (float) height.at(x, y);
                if (x + 1 == n || y + 1 == n) continue;
                for (int w : new int[] {v, v + 1, v + n + 1, v, v + n + 1, v + n}) faces[at++] = w;
            }
        }
        return new MeshBuilder().positions(positions).faceWedges(faces).build();
    }
}
