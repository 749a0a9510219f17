package org.jsmesh.collapse;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.patch.PatchLog;
import org.junit.jupiter.api.Test;

class SeparateTrianglesTest {
    private static final SimplificationTarget TARGET = SimplificationTarget.ofFaces(20);

    @Test
    void shouldRemoveWhatTheGeneralWayRemoves() {
        for (Mesh mesh : new Mesh[] {book(700), soup(700), soup(1)}) {
            CollapseMesh apart = new CollapseMesh(mesh);
            assertThat(apart.isApart()).isTrue();
            new SeparateTriangles(apart, TARGET, ProgressListener.NONE).simplify();
            CollapseMesh general = new CollapseMesh(mesh);
            new QuadricSimplifier(general, TARGET, Effort.SOME, ProgressListener.NONE, Runnable::run, 1).run();
            assertThat(lines(apart.log())).isEqualTo(lines(general.log()));
            assertThat(apart.liveFaces()).isEqualTo(general.liveFaces());
        }
    }

    @Test
    void shouldNotTakeNeighboursForSeparate() {
        Mesh two = mesh(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, new int[] {0, 1, 2, 2, 1, 3});
        assertThat(new CollapseMesh(two).isApart()).isFalse();
    }

    private static String lines(PatchLog log) {
        StringBuilder lines = new StringBuilder();
        for (int i = 0; i < log.components(); i++)
            lines.append(log.componentFace(i)).append(' ');
        for (int i = 0; i < log.passes(); i++)
            lines.append('\n').append(log.componentStart(i)).append(' ').append(log.threshold(log.passLevel(i)));
        return lines.append('\n').append(log.size()).toString();
    }

    /** Triangles about one edge. */
    private static Mesh book(int n) {
        float[] p = positions(n + 2);
        int[] faces = new int[3 * n];
        for (int f = 0; f < n; f++) {
            faces[3 * f + 1] = 1;
            faces[3 * f + 2] = f + 2;
        }
        return mesh(p, faces);
    }

    private static Mesh soup(int n) {
        int[] faces = new int[3 * n];
        Arrays.setAll(faces, i -> i);
        return mesh(positions(3 * n), faces);
    }

    private static float[] positions(int n) {
        Random random = new Random(n);
        float[] p = new float[3 * n];
        for (int i = 0; i < p.length; i++) p[i] = random.nextFloat();
        return p;
    }

    private static Mesh mesh(float[] positions, int[] faces) {
        return new MeshBuilder().positions(positions).faceWedges(faces).build();
    }
}
