package org.jsmesh.files.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.io.ModelFile;
import org.jsmesh.mesh.io.ModelFormatException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class GltfReaderTest {
    private static List<Float> corner(Mesh mesh, int face, int i) {
        int p = 3 * mesh.vertex(face, i);
        return List.of(mesh.positions()[p], mesh.positions()[p + 1], mesh.positions()[p + 2]);
    }

    private static List<Float> at(Mesh mesh, Channel.Semantic semantic, int face, int i) {
        Channel channel = mesh.channel(semantic);
        int wedge = mesh.faceWedges()[3 * face + i];
        if (channel.isAbsent(wedge)) return null;
        List<Float> values = new ArrayList<>();
        for (int c = 0; c < channel.components(); c++) values.add(channel.number(wedge, c));
        return values;
    }

    @Test
    void shouldKeepEveryBitUnderNodesWithoutTransform() throws IOException {
        GlbBuilder builder = new GlbBuilder();
        builder.floats("VEC3", -0f, Float.MIN_VALUE, 1e38f, 1, 0, 0, 0, 1, 0);
        builder.floats("VEC3", 0, 0, .3f, 0, 0, 1, 0, 0, 1);
        Mesh mesh = builder.primitive("{\"attributes\":{\"POSITION\":0,\"NORMAL\":1}}")
                .nodes("{\"mesh\":0,\"matrix\":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}")
                .read()
                .mesh();
        assertThat(corner(mesh, 0, 0)).containsExactly(-0f, Float.MIN_VALUE, 1e38f);
        assertThat(at(mesh, Channel.Semantic.NORMAL, 0, 0)).containsExactly(0f, 0f, .3f);
    }

    @Test
    void shouldBakeNestedTransformsInDoubles() throws IOException {
        Mesh mesh = GlbBuilder.triangle()
                .nodes(
                        "{\"children\":[1],\"translation\":[0.1,0,0]},{\"mesh\":0,\"scale\":[0.1,2,2],\"rotation\":[0,0,0,1]}")
                .read()
                .mesh();
        assertThat(corner(mesh, 0, 1)).containsExactly((float) (0.1 * 1 + 0.1), 0f, 0f);
        assertThat(corner(mesh, 0, 2)).containsExactly((float) 0.1, 2f, 0f);
    }

    @Test
    void shouldTurnFacesOfMirroredNodesBack() throws IOException {
        Mesh mesh = GlbBuilder.triangle()
                .nodes("{\"mesh\":0,\"scale\":[-1,1,1]}")
                .read()
                .mesh();
        assertThat(List.of(corner(mesh, 0, 0), corner(mesh, 0, 1), corner(mesh, 0, 2)))
                .containsExactly(List.of(0f, 1f, 0f), List.of(-1f, 0f, 0f), List.of(0f, 0f, 0f));
        assertThat(at(mesh, Channel.Semantic.NORMAL, 0, 0)).containsExactly(0f, 0f, 1f);
    }

    @Test
    void shouldTransformNormalsByTheInverseTranspose() throws IOException {
        GlbBuilder builder = new GlbBuilder();
        float h = (float) Math.sqrt(.5);
        builder.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
        builder.floats("VEC3", h, h, 0, 0, 0, 0, 0, 0, 1);
        Mesh mesh = builder.primitive("{\"attributes\":{\"POSITION\":0,\"NORMAL\":1}}")
                .nodes("{\"mesh\":0,\"scale\":[2,1,-1]}")
                .read()
                .mesh();
        assertThat(at(mesh, Channel.Semantic.NORMAL, 0, 2))
                .containsExactly((float) (.5 / Math.sqrt(1.25)), (float) (1 / Math.sqrt(1.25)), 0f);
        assertThat(at(mesh, Channel.Semantic.NORMAL, 0, 1)).containsExactly(0f, 0f, 0f);
        assertThat(at(mesh, Channel.Semantic.NORMAL, 0, 0)).containsExactly(0f, 0f, -1f);
    }

    @ParameterizedTest
    @CsvSource({"5,'0 1 2 2 1 3 '", "6,'0 1 2 0 2 3 '", "4,'0 1 2 '"})
    void shouldReadStripsFansAndListsWithoutIndices(int mode, String expected) throws IOException {
        GlbBuilder builder = new GlbBuilder();
        builder.floats("VEC3", 0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0);
        Mesh mesh = builder.primitive("{\"attributes\":{\"POSITION\":0},\"mode\":" + mode + "}")
                .read()
                .mesh();
        StringBuilder corners = new StringBuilder();
        for (int c = 0; c < 3 * mesh.faces(); c++)
            corners.append((int) (float) corner(mesh, c / 3, c % 3).get(0)).append(' ');
        assertThat(corners).hasToString(expected);
    }

    @Test
    void shouldDropStitchesOfStripsAndLeaveOutPoints() throws IOException {
        GlbBuilder builder = new GlbBuilder();
        builder.floats("VEC3", 0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0);
        builder.bytes(5121, "SCALAR", 6, "", 0, 1, 2, 2, 3, 3);
        ModelFile file = builder.primitive("{\"attributes\":{\"POSITION\":0},\"mode\":5,\"indices\":1}")
                .primitive("{\"attributes\":{\"POSITION\":0},\"mode\":0}")
                .read();
        assertThat(file.mesh().faces()).isEqualTo(1);
        assertThat(file.notes())
                .containsExactly(
                        Note.dropped("1 primitive left out: points, lines or no positions.", 1, "")
                                .asWarning(),
                        Note.repaired("3 degenerate triangles that stitch strips dropped.", 3, ""));
    }

    @Test
    void shouldWeldSeamsAndMarkWhatAPrimitiveLacksAsAbsent() throws IOException {
        GlbBuilder builder = new GlbBuilder();
        builder.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
        builder.floats("VEC2", 0, 0, 1, 0, 0, 1);
        Mesh mesh = builder.primitive("{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1}}")
                .primitive("{\"attributes\":{\"POSITION\":0}}")
                .read()
                .mesh();
        assertThat(mesh.vertices()).isEqualTo(3);
        assertThat(mesh.wedges()).isEqualTo(6);
        assertThat(at(mesh, Channel.Semantic.TEXCOORD, 0, 1)).containsExactly(1f, 0f);
        assertThat(at(mesh, Channel.Semantic.TEXCOORD, 1, 1)).isNull();
    }

    @Test
    void shouldReadNormalizedIntegers() throws IOException {
        GlbBuilder builder = new GlbBuilder();
        builder.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
        builder.bytes(5123, "VEC2", 3, ",\"normalized\":true", 255, 255, 0, 0, 51, 51, 0, 0, 0, 0, 0, 0);
        builder.bytes(5121, "VEC4", 3, ",\"normalized\":true", 1, 2, 3, 4, 5, 6, 7, 8, 255, 0, 0, 0);
        Mesh mesh = builder.primitive("{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1,\"COLOR_0\":2}}")
                .read()
                .mesh();
        assertThat(at(mesh, Channel.Semantic.TEXCOORD, 0, 0)).containsExactly(1f, 0f);
        assertThat(at(mesh, Channel.Semantic.TEXCOORD, 0, 1)).containsExactly((float) (0x3333 / 65535.0), 0f);
        assertThat(mesh.channel(Channel.Semantic.COLOUR).type()).isEqualTo(Channel.Type.UINT8);
        assertThat(mesh.channel(Channel.Semantic.COLOUR).values()).startsWith(1, 2, 3, 4, 5, 6, 7, 8);
    }

    @Test
    void shouldMixColoursOfBytesAndFloatsAsFloats() throws IOException {
        GlbBuilder builder = new GlbBuilder();
        builder.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
        builder.bytes(5121, "VEC4", 3, ",\"normalized\":true", 255, 51, 0, 0, 5, 6, 7, 8, 255, 0, 0, 0);
        builder.floats("VEC3", .5f, .5f, .5f, 0, 0, 0, 1, 1, 1);
        Mesh mesh = builder.primitive("{\"attributes\":{\"POSITION\":0,\"COLOR_0\":1}}")
                .primitive("{\"attributes\":{\"POSITION\":0,\"COLOR_0\":2}}")
                .read()
                .mesh();
        assertThat(at(mesh, Channel.Semantic.COLOUR, 0, 0)).containsExactly(1f, .2f, 0f, 0f);
        assertThat(at(mesh, Channel.Semantic.COLOUR, 1, 0)).containsExactly(.5f, .5f, .5f, 1f);
    }

    @Test
    void shouldFillInSparseValues() throws IOException {
        GlbBuilder builder = new GlbBuilder();
        int indices = builder.view(new byte[] {1, 2});
        int values = builder.view(ByteBuffer.allocate(24)
                .order(ByteOrder.LITTLE_ENDIAN)
                .putFloat(1)
                .putFloat(0)
                .putFloat(0)
                .putFloat(0)
                .putFloat(1)
                .putFloat(0)
                .array());
        builder.accessorText(
                "{\"componentType\":5126,\"type\":\"VEC3\",\"count\":3,\"sparse\":{\"count\":2,\"indices\":{\"bufferView\":"
                        + indices + ",\"componentType\":5121},\"values\":{\"bufferView\":" + values + "}}}");
        Mesh mesh =
                builder.primitive("{\"attributes\":{\"POSITION\":0}}").read().mesh();
        assertThat(corner(mesh, 0, 0)).containsExactly(0f, 0f, 0f);
        assertThat(corner(mesh, 0, 2)).containsExactly(0f, 1f, 0f);
    }

    @Test
    void shouldReportWhatItDrops() throws IOException {
        GlbBuilder builder = GlbBuilder.triangle()
                .primitive(
                        "{\"attributes\":{\"POSITION\":0,\"COLOUR\":1,\"TEXCOORD\":1},\"targets\":[{\"POSITION\":0}]}");
        ModelFile file = builder.rest(
                        ",\"skins\":[{\"joints\":[0]}],\"animations\":[{\"channels\":[{\"sampler\":0,\"target\":{\"path\":\"scale\"}}],\"samplers\":[{\"input\":0,\"output\":0}]}],"
                                + "\"extensionsUsed\":[\"KHR_materials_unlit\",\"KHR_xmp_json_ld\",\"KHR_mesh_quantization\"]")
                .read();
        assertThat(file.notes())
                .containsExactly(
                        Note.unread("Extensions not read: KHR_xmp_json_ld.", 1, "KHR_xmp_json_ld"),
                        Note.dropped("Morph targets dropped.", 1, ""),
                        Note.dropped("Vertex attributes dropped: COLOUR, TEXCOORD.", 2, "COLOUR"),
                        Note.dropped("Skins dropped: meshes are in the pose they were modelled in.", 1, "skin 0"),
                        Note.dropped("Animations dropped.", 1, "animation 0"));
    }

    @Test
    void shouldReadTheJsonFormWithItsBufferBesideItOrWithin() throws IOException {
        GlbBuilder builder = GlbBuilder.triangle();
        byte[] beside = builder.gltf("my%20data.bin").getBytes(StandardCharsets.UTF_8);
        assertThat(GltfReader.read(
                                "a.gltf",
                                beside,
                                p -> p.equals("my data.bin") ? Optional.of(builder.binary()) : Optional.empty())
                        .mesh()
                        .faces())
                .isEqualTo(1);
        String data =
                "data:application/octet-stream;base64," + Base64.getEncoder().encodeToString(builder.binary());
        assertThat(GltfReader.read("a.gltf", builder.gltf(data).getBytes(StandardCharsets.UTF_8), p -> Optional.empty())
                        .mesh()
                        .faces())
                .isEqualTo(1);
        assertThatThrownBy(() -> GltfReader.read("a.gltf", beside, p -> Optional.empty()))
                .isInstanceOf(ModelFormatException.class)
                .hasMessageContaining("Put all .bin files beside the .gltf file");
    }
}
