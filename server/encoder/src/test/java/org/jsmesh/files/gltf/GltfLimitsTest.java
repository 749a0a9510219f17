package org.jsmesh.files.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.jsmesh.mesh.io.ModelFormatException;
import org.junit.jupiter.api.Test;

/** Small files that would make much work. */
class GltfLimitsTest {
    private static String zeros(int type, String kind, int count) {
        return "{\"componentType\":" + type + ",\"type\":\"" + kind + "\",\"count\":" + count + "}";
    }

    private static String instanced(int accessor) {
        return "{\"mesh\":0,\"extensions\":{\"EXT_mesh_gpu_instancing\":{\"attributes\":{\"TRANSLATION\":" + accessor
                + "}}}}";
    }

    private static GlbBuilder list(int faces) {
        GlbBuilder builder = new GlbBuilder();
        builder.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
        int[] indices = IntStream.range(0, 3 * faces).map(i -> i % 3).toArray();
        int number = builder.bytes(5121, "SCALAR", indices.length, "", indices);
        return builder.primitive("{\"attributes\":{\"POSITION\":0},\"indices\":" + number + "}");
    }

    @Test
    void shouldRefuseManyIndicesWithoutBytes() {
        GlbBuilder builder = GlbBuilder.triangle();
        builder.accessorText(zeros(5125, "SCALAR", 260_000))
                .primitive("{\"attributes\":{\"POSITION\":0},\"indices\":2}");
        assertThatThrownBy(builder::read)
                .isInstanceOf(ModelFormatException.class)
                .hasMessageContaining("accessor 2 has 260000 elements without bytes");
    }

    @Test
    void shouldRefuseManyInstancesOfTrianglesWithoutBytes() {
        GlbBuilder builder = new GlbBuilder();
        builder.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
        builder.accessorText(zeros(5125, "SCALAR", 3000)).primitive("{\"attributes\":{\"POSITION\":0},\"indices\":1}");
        float[] places = new float[3 * 300];
        assertThatThrownBy(() ->
                        builder.nodes(instanced(builder.floats("VEC3", places))).read())
                .isInstanceOf(ModelFormatException.class)
                .hasMessageContaining("triangles without bytes of the file behind them");
    }

    @Test
    void shouldRefuseManyInstancesWithoutBytes() {
        GlbBuilder builder = list(100);
        builder.accessorText(zeros(5126, "VEC3", 3000)).nodes(instanced(2));
        assertThatThrownBy(builder::read)
                .isInstanceOf(ModelFormatException.class)
                .hasMessageContaining("triangles without bytes of the file behind them")
                .hasMessageContaining("remove repeated meshes");
    }

    @Test
    void shouldRefuseANodeThatManyWaysLeadTo() {
        StringBuilder nodes = new StringBuilder();
        for (int level = 1; level <= 12; level++) nodes.append("{\"children\":[" + level + "," + level + "]},");
        assertThatThrownBy(() -> list(100).nodes(nodes + "{\"mesh\":0}").read())
                .isInstanceOf(ModelFormatException.class)
                .hasMessageContaining("triangles without bytes of the file behind them");
    }

    @Test
    void shouldRefuseMoreRepeatsThanAnybodyMeans() {
        GlbBuilder builder = list(2000);
        int places = builder.floats("VEC3", new float[3 * 2100]);
        assertThatThrownBy(() -> builder.nodes(instanced(places)).read())
                .isInstanceOf(ModelFormatException.class)
                .hasMessageContaining("remove repeated meshes");
    }

    @Test
    void shouldRepeatTrianglesThatHaveBytes() throws IOException {
        GlbBuilder builder = list(300);
        int places = builder.floats("VEC3", new float[3 * 1000]);
        assertThat(builder.nodes(instanced(places)).read().mesh().faces()).isEqualTo(300_000);
    }

    @Test
    void shouldCountFacesBeforeNodesAreExpanded() throws IOException {
        String nodes = IntStream.range(0, 5).mapToObj(i -> "{\"mesh\":0}").collect(Collectors.joining(","));
        byte[] glb =
                list(10).nodes("{\"mesh\":0,\"children\":[1,2,3,4,5]}," + nodes).glb();
        assertThat(GltfReader.read("a.glb", glb, p -> Optional.empty(), 60)
                        .mesh()
                        .faces())
                .isEqualTo(60);
        assertThatThrownBy(() -> GltfReader.read("a.glb", glb, p -> Optional.empty(), 59))
                .isInstanceOf(ModelFormatException.class)
                .hasMessage("a.glb: the model has 60 faces, more than the 59 allowed. Give a smaller model.");
    }

    @Test
    void shouldNotCountTrianglesThatStitchAStrip() throws IOException {
        GlbBuilder builder = GlbBuilder.triangle();
        int indices = builder.bytes(5121, "SCALAR", 6, "", 0, 1, 2, 2, 2, 2);
        byte[] glb = builder.primitive("{\"attributes\":{\"POSITION\":0},\"mode\":5,\"indices\":" + indices + "}")
                .glb();
        assertThat(GltfReader.read("a.glb", glb, p -> Optional.empty(), 2)
                        .mesh()
                        .faces())
                .isEqualTo(2);
    }
}
