package org.jsmesh.desktop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.BitSet;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.junit.jupiter.api.Test;

class RenderMeshTest {
    private static RenderMesh render(Mesh mesh) {
        return RenderMesh.of(mesh, Framing.of(mesh.bounds()));
    }

    @Test
    void shouldGiveOneVertexPerWedgeInUnitSpace() {
        Mesh mesh = new MeshBuilder()
                .positions(new float[] {1e6f, 0, 0, 1e6f + 2, 0, 0, 1e6f, 2, 1})
                .wedgeVertices(new int[] {2, 0, 1, 0})
                .faceWedges(new int[] {1, 2, 0, 3, 0, 2})
                .build();
        RenderMesh r = render(mesh);
        assertThat(r.vertices()).isEqualTo(4);
        assertThat(r.faces()).isEqualTo(2);
        assertThat(r.positions())
                .containsExactly(
                        new float[] {
                            -2f / 3, 2f / 3, 1f / 3, -2f / 3, -2f / 3, -1f / 3, 2f / 3, -2f / 3, -1f / 3, -2f / 3,
                            -2f / 3, -1f / 3
                        },
                        within(1e-6f));
        assertThat(r.texCoords()).isNull();
        assertThat(r.colours()).isNull();
    }

    @Test
    void shouldWeightComputedNormalsByArea() {
        // A large face that looks along +z and a small one that looks along +x share the edge 0-1.
        Mesh mesh = new MeshBuilder()
                .positions(new float[] {0, 0, 0, 0, 2, 0, -3, 0, 0, 0, 0, -1})
                .faceWedges(new int[] {0, 1, 2, 0, 3, 1})
                .build();
        float[] n = render(mesh).normals();
        double length = Math.sqrt(10);
        assertThat(n[0]).isCloseTo((float) (1 / length), within(1e-6f));
        assertThat(n[2]).isCloseTo((float) (3 / length), within(1e-6f));
        assertThat(new float[] {n[6], n[7], n[8]}).containsExactly(0, 0, 1);
        assertThat(new float[] {n[9], n[10], n[11]}).containsExactly(1, 0, 0);
    }

    @Test
    void shouldGiveDegenerateFacesSomeNormal() {
        Mesh mesh = new MeshBuilder()
                .positions(new float[] {0, 0, 0, 1, 1, 1, 2, 2, 2})
                .faceWedges(new int[] {0, 1, 2, 1, 1, 1})
                .build();
        assertThat(render(mesh).normals()).containsExactly(0, 0, 1, 0, 0, 1, 0, 0, 1);
    }

    @Test
    void shouldTakeNormalsOfTheFileAndComputeAbsentOnes() {
        BitSet absent = new BitSet();
        absent.set(2);
        int one = Float.floatToIntBits(1);
        Channel channel = new Channel(
                Channel.Semantic.NORMAL,
                "normal",
                3,
                Channel.Type.FLOAT32,
                new int[] {one, 0, 0, 0, one, 0, 0, 0, 0},
                absent);
        Mesh mesh = new MeshBuilder()
                .positions(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0})
                .faceWedges(new int[] {0, 1, 2})
                .channels(List.of(channel))
                .build();
        assertThat(render(mesh).normals()).containsExactly(1, 0, 0, 0, 1, 0, 0, 0, 1);
    }

    @Test
    void shouldGroupFacesByMaterialAndKeepTheirCorners() {
        Mesh mesh = Shapes.paintedTorus(6, 4);
        RenderMesh r = render(mesh);
        assertThat(r.groups()).extracting(RenderMesh.Group::first).containsExactly(0, 48, 96);
        assertThat(r.groups()).extracting(RenderMesh.Group::count).containsExactly(48, 48, 48);
        // The last third of the faces has the first material.
        assertThat(r.indices()).startsWith(java.util.Arrays.copyOfRange(mesh.faceWedges(), 96, 144));
        assertThat(r.groups().get(2).surface().red()).isEqualTo(.6f);
        assertThat(r.groups().get(0).surface().blue()).isCloseTo(Surface.linear(.9f), within(0f));
    }

    @Test
    void shouldDrawTranslucentMaterialsLast() {
        Mesh torus = Shapes.paintedTorus(6, 4);
        var glass = new org.jsmesh.mesh.Material(
                "glass",
                List.of(
                        new org.jsmesh.mesh.Material.Parameter("Kd", 1, 1, 1),
                        new org.jsmesh.mesh.Material.Parameter("d", .5f)),
                List.of());
        Mesh mesh = MeshBuilder.from(torus)
                .materials(List.of(
                        glass, torus.materials().get(1), torus.materials().get(2)))
                .build();
        List<RenderMesh.Group> groups = render(mesh).groups();
        assertThat(groups).extracting(g -> g.surface().isOpaque()).containsExactly(true, true, false);
        assertThat(groups.get(2).first()).isZero();
    }

    @Test
    void shouldGiveColoursAsBytesAndTexCoordsOnlyForTextures() {
        RenderMesh coloured = render(Shapes.colouredTorus(6, 4));
        assertThat(coloured.colours()).hasSize(4 * 24).startsWith((byte) 127);
        assertThat(coloured.groups().get(0).surface().red()).isEqualTo(1);
        RenderMesh square = render(Shapes.texturedSquare("map_Kd"));
        assertThat(square.texCoords()).containsExactly(0, 0, 1, 0, 1, 1, 0, 1);
        assertThat(square.groups().get(0).surface().isGltf()).isFalse();
        assertThat(render(Shapes.texturedSquare("baseColorTexture"))
                        .groups()
                        .get(0)
                        .surface()
                        .isGltf())
                .isTrue();
    }
}
