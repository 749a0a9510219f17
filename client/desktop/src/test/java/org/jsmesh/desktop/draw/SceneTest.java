package org.jsmesh.desktop.draw;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.jsmesh.display.RenderMesh;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.UpAxis;
import org.junit.jupiter.api.Test;

class SceneTest {
    @Test
    void shouldPutPositionsIntoUnitSpace() {
        Mesh mesh = new MeshBuilder()
                .positions(new float[] {1e6f, 0, 0, 1e6f + 2, 0, 0, 1e6f, 2, 1})
                .wedgeVertices(new int[] {2, 0, 1, 0})
                .faceWedges(new int[] {1, 2, 0, 3, 0, 2})
                .build();
        float third = 1f / 3;
        assertThat(scene(mesh, -1).mesh().positions())
                .containsExactly(
                        new float[] {
                            -2 * third,
                            2 * third,
                            third,
                            -2 * third,
                            -2 * third,
                            -third,
                            2 * third,
                            -2 * third,
                            -third,
                            -2 * third,
                            -2 * third,
                            -third
                        },
                        within(1e-6f));
    }

    @Test
    void shouldDrawWhatThePageDrawsBesidesPositions() {
        for (Mesh mesh : new Mesh[] {Shapes.cube(), Shapes.paintedTorus(9, 5), Shapes.texturedSquare("map_Kd")}) {
            double crease = Math.cos(Math.toRadians(42));
            RenderMesh page = RenderMesh.of(mesh, crease);
            RenderMesh window = scene(mesh, crease).mesh();
            assertThat(window.normals()).isEqualTo(page.normals());
            assertThat(window.textureCoordinates()).isDeepEqualTo(page.textureCoordinates());
            assertThat(window.colours()).isEqualTo(page.colours());
            assertThat(window.indices()).isEqualTo(page.indices());
            assertThat(window.groups()).isEqualTo(page.groups());
            assertThat(window.positions())
                    .isEqualTo(Framing.of(mesh.bounds(), UpAxis.UNKNOWN).toUnit(page.positions()));
        }
    }

    @Test
    void shouldTurnAModelWhoseZAxisPointsUp() {
        Mesh mesh = Shapes.paintedTorus(9, 5);
        double crease = Math.cos(Math.toRadians(42));
        RenderMesh lying = scene(mesh, crease).mesh();
        Framing framing = Framing.of(mesh.bounds(), UpAxis.Z);
        RenderMesh standing =
                Scene.of(mesh, crease, false, framing, new TextureImages()).mesh();
        assertThat(standing.positions()).isEqualTo(turned(lying.positions()));
        assertThat(standing.normals()).isEqualTo(turned(lying.normals()));
        Framing box = Framing.of(new float[] {-1, -2, -3, 1, 2, 3}, UpAxis.Z);
        assertThat(box.halfY() / box.halfX()).isEqualTo(3);
        assertThat(box.halfZ() / box.halfX()).isEqualTo(2);
    }

    private static float[] turned(float[] points) {
        float[] turned = new float[points.length];
        for (int i = 0; i < points.length; i += 3) {
            turned[i] = points[i];
            turned[i + 1] = points[i + 2];
            turned[i + 2] = -points[i + 1];
        }
        return turned;
    }

    private static Scene scene(Mesh mesh, double creaseCosine) {
        return Scene.of(mesh, creaseCosine, false, Framing.of(mesh.bounds(), UpAxis.UNKNOWN), new TextureImages());
    }
}
