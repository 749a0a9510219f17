package org.jsmesh.desktop.draw;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.jsmesh.display.RenderMesh;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.MeshBuilder;
import org.junit.jupiter.api.Test;

class FarFirstTest {
    private static final double[] FRONT = new Camera(0, 0, 3, 0, 0, 0).view();
    private static final double[] BACK = new Camera(Math.PI, 0, 3, 0, 0, 0).view();

    /** Triangles across the z axis: those of the first material at 0 and 2, those of the second at 3 and −1. */
    private static RenderMesh mesh() {
        float[] z = {0, 2, 3, -1};
        float[] positions = new float[36];
        for (int v = 0; v < 12; v++) {
            positions[3 * v] = v % 3 == 1 ? 1 : 0;
            positions[3 * v + 1] = v % 3 == 2 ? 1 : 0;
            positions[3 * v + 2] = z[v / 3];
        }
        int[] corners = new int[12];
        for (int i = 0; i < 12; i++) corners[i] = i;
        return RenderMesh.of(
                new MeshBuilder()
                        .positions(positions)
                        .faceWedges(corners)
                        .faceMaterials(new int[] {0, 0, 1, 1})
                        .materials(List.of(
                                new Material("a", List.of(new Material.Parameter("d", .5f)), List.of()),
                                new Material("b", List.of(new Material.Parameter("d", .4f)), List.of())))
                        .build(),
                1);
    }

    @Test
    void shouldDrawTheFacesOfAGroupFromFarToNear() {
        FarFirst front = new FarFirst(mesh(), FRONT);
        FarFirst back = new FarFirst(mesh(), BACK);
        assertThat(front.faces(0, 6)).containsExactly(0, 1, 2, 3, 4, 5);
        assertThat(back.faces(0, 6)).containsExactly(3, 4, 5, 0, 1, 2);
        assertThat(front.faces(6, 6)).containsExactly(9, 10, 11, 6, 7, 8);
        assertThat(back.faces(6, 6)).containsExactly(6, 7, 8, 9, 10, 11);
    }

    @Test
    void shouldDrawGroupsByTheirMiddles() {
        RenderMesh mesh = mesh();
        // Both have the middle 1: whichever comes first in the file stays first.
        assertThat(new FarFirst(mesh, FRONT).groups(List.of(3, 6))).containsExactly(3, 6);
        float[] moved = mesh.positions().clone();
        for (int v = 0; v < 6; v++) moved[3 * v + 2] += 5;
        assertThat(new FarFirst(mesh.withPositions(moved), FRONT).groups(List.of(3, 6)))
                .containsExactly(6, 3);
        assertThat(new FarFirst(mesh.withPositions(moved), BACK).groups(List.of(3, 6)))
                .containsExactly(3, 6);
    }

    @Test
    void shouldKeepTheOrderOfFacesAtOneDepth() {
        RenderMesh mesh = mesh();
        float[] level = mesh.positions().clone();
        for (int v = 0; v < 12; v++) level[3 * v + 2] = 1;
        assertThat(new FarFirst(mesh.withPositions(level), FRONT).faces(0, 12)).isEqualTo(mesh.indices());
    }
}
