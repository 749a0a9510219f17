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

    /** Triangles across the z axis: the first two of the first material, the others of the second. */
    private static RenderMesh mesh(float... z) {
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

    private static FarFirst.Order order(double[] view, float... z) {
        RenderMesh mesh = mesh(z);
        return new FarFirst(MeshArrays.of(mesh), view).order(mesh.groups());
    }

    private static int[] faces(double[] view, float... z) {
        int[] indices = order(view, z).indices();
        int[] faces = new int[indices.length / 3];
        for (int f = 0; f < faces.length; f++) faces[f] = indices[3 * f] / 3;
        return faces;
    }

    @Test
    void shouldDrawFacesFromFarToNearWhateverTheirMaterial() {
        assertThat(faces(FRONT, 0, 2, 3, -1)).containsExactly(3, 0, 1, 2);
        assertThat(faces(BACK, 0, 2, 3, -1)).containsExactly(2, 1, 0, 3);
    }

    @Test
    void shouldDrawNeighboursOfOneMaterialAtOnce() {
        assertThat(order(FRONT, 0, 2, 3, -1).runs()).containsExactly(2, 0, 3, 1, 3, 6, 2, 9, 3);
        assertThat(order(FRONT, 0, 1, 2, 3).runs()).containsExactly(1, 0, 6, 2, 6, 6);
    }

    @Test
    void shouldKeepTheOrderOfFacesAtOneDepth() {
        assertThat(faces(FRONT, 1, 1, 1, 1)).containsExactly(0, 1, 2, 3);
    }
}
