package org.jsmesh.collapse;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.patch.PatchLog;
import org.junit.jupiter.api.Test;

class ComponentRemovalTest {
    @Test
    void shouldRemoveTheSmallestFirst() {
        int n = 400;
        double[] size = new double[n];
        Random random = new Random(1);
        for (int i = 0; i < n; i++) size[i] = .01 * Math.pow(100, random.nextDouble());
        PatchLog log = simplified(scattered(n, i -> size[(int) i])).log();
        assertThat(log.components()).isGreaterThan(300);
        double first = 0;
        double last = 0;
        int part = log.components() / 4;
        for (int i = 0; i < part; i++) {
            first += size[log.componentFace(i)];
            last += size[log.componentFace(log.components() - 1 - i)];
        }
        assertThat(last).isGreaterThan(8 * first);
    }

    /** Equal ones go from everywhere, half of them at a time. */
    @Test
    void shouldThinOutACrowd() {
        CollapseMesh mesh = new CollapseMesh(scattered(4000, i -> .05));
        QuadricSimplifier.simplify(mesh, SimplificationTarget.ofFaces(1000), Effort.SOME, ProgressListener.NONE);
        assertThat(mesh.liveFaces()).isEqualTo(1000);
        int[] octants = new int[8];
        for (int f = 0; f < 4000; f++) {
            if (!mesh.isLiveFace(f)) continue;
            int v = mesh.table().vertex(CornerTable.STRIDE * f);
            int octant = 0;
            for (int a = 0; a < 3; a++) if (mesh.position(v, a) > 0) octant |= 1 << a;
            octants[octant]++;
        }
        for (int count : octants) assertThat(count).isBetween(85, 165);
        PatchLog log = mesh.log();
        assertThat(log.passes()).isGreaterThan(1);
        int before = 4000;
        for (int pass = 0; pass < log.passes(); pass++) {
            int gone = log.componentStart(pass + 1) - log.componentStart(pass);
            assertThat(gone).isLessThanOrEqualTo((before + 1) / 2);
            before -= gone;
        }
    }

    @Test
    void shouldKeepTheBoundingBoxAndWhatIsLarge() {
        Mesh crowd = scattered(1000, i -> i == 500 ? 4 : .02);
        CollapseMesh mesh = simplified(crowd);
        assertThat(mesh.liveFaces()).isBetween(3, 8);
        assertThat(mesh.isLiveFace(500)).isTrue();
        float[] box = crowd.bounds();
        double margin = .0021 * diagonal(box);
        for (int side = 0; side < 6; side++) {
            double closest = Double.POSITIVE_INFINITY;
            for (int f = 0; f < 1000; f++) {
                for (int j = 0; j < 3 && mesh.isLiveFace(f); j++) {
                    int v = mesh.table().vertex(CornerTable.STRIDE * f + j);
                    closest = Math.min(closest, Math.abs(mesh.position(v, side % 3) - box[side]));
                }
            }
            assertThat(closest).as("side %d", side).isLessThan(margin);
        }
    }

    @Test
    void shouldNeverRemoveAll() {
        for (int n = 1; n < 5; n++) {
            CollapseMesh mesh = simplified(new MeshBuilder()
                    .positions(new float[9 * n])
                    .faceWedges(corners(n))
                    .build());
            assertThat(mesh.liveFaces()).isPositive();
        }
    }

    /** A single triangle beside a sheet stays while collapses of the sheet matter less. */
    @Test
    void shouldLetCollapsesGoFirst() {
        int n = 30;
        float[] p = new float[3 * (n * n + 3)];
        int[] faces = new int[6 * (n - 1) * (n - 1) + 3];
        int at = 0;
        for (int y = 0; y < n; y++) {
            for (int x = 0; x < n; x++) {
                int v = y * n + x;
                p[3 * v] = x;
                p[3 * v + 1] = y;
                p[3 * v + 2] = (float) (.5 * Math.sin(.4 * x) * Math.cos(.3 * y));
                if (x + 1 == n || y + 1 == n) continue;
                for (int w : new int[] {v, v + 1, v + n + 1, v, v + n + 1, v + n}) faces[at++] = w;
            }
        }
        for (int i = 0; i < 3; i++) {
            faces[at++] = n * n + i;
            for (int a = 0; a < 2; a++) p[3 * (n * n + i) + a] = 12 + (i == a + 1 ? 3 : 0);
        }
        CollapseMesh mesh =
                simplified(new MeshBuilder().positions(p).faceWedges(faces).build());
        PatchLog log = mesh.log();
        assertThat(log.components()).isEqualTo(1);
        int pass = 0;
        while (log.componentStart(pass + 1) == 0) pass++;
        assertThat(log.passStart(pass)).isGreaterThan(n * n / 2);
    }

    private static CollapseMesh simplified(Mesh mesh) {
        CollapseMesh collapsing = new CollapseMesh(mesh);
        QuadricSimplifier.simplify(collapsing, SimplificationTarget.floor(), Effort.SOME, ProgressListener.NONE);
        return collapsing;
    }

    private static double diagonal(float[] box) {
        double sum = 0;
        for (int a = 0; a < 3; a++) sum += ((double) box[a + 3] - box[a]) * (box[a + 3] - box[a]);
        return Math.sqrt(sum);
    }

    private static int[] corners(int faces) {
        int[] corners = new int[3 * faces];
        Arrays.setAll(corners, i -> i);
        return corners;
    }

    /** Separate triangles in a cube of side 20. */
    private static Mesh scattered(int n, DoubleUnaryOperator size) {
        Random random = new Random(2);
        float[] p = new float[9 * n];
        for (int f = 0; f < n; f++) {
            for (int a = 0; a < 3; a++) {
                double middle = 20 * random.nextDouble() - 10;
                for (int j = 0; j < 3; j++)
                    p[9 * f + 3 * j + a] = (float) (middle + size.applyAsDouble(f) * random.nextGaussian());
            }
        }
        return new MeshBuilder().positions(p).faceWedges(corners(n)).build();
    }
}
