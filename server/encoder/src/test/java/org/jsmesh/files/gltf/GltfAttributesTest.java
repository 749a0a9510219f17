package org.jsmesh.files.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.jsmesh.files.gltf.GltfChannels.at;
import static org.jsmesh.files.gltf.GltfChannels.named;
import static org.jsmesh.files.gltf.GltfChannels.names;
import static org.jsmesh.files.gltf.GltfChannels.position;

import java.io.IOException;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.io.ModelFile;
import org.junit.jupiter.api.Test;

/** Attributes keep glTF's names and the types in which they are stored. */
class GltfAttributesTest {
    private static final String NORMALIZED = ",\"normalized\":true";

    /** A triangle in the plane z = 0 without anything else. */
    private static GlbBuilder bare() {
        GlbBuilder builder = new GlbBuilder();
        builder.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
        return builder;
    }

    private static ModelFile read(GlbBuilder builder, String attributes) throws IOException {
        return builder.primitive("{\"attributes\":{\"POSITION\":0" + attributes + "}}")
                .read();
    }

    @Test
    void shouldKeepJointsWeightsTangentsAndOwnAttributesUnderTheirNames() throws IOException {
        GlbBuilder builder = bare();
        builder.bytes(5121, "VEC4", 3, "", 1, 2, 3, 200, 0, 0, 0, 0, 0, 0, 0, 0);
        builder.shorts(5123, "VEC4", 3, NORMALIZED, 65535, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
        builder.floats("VEC4", 1, 0, 0, -1, 1, 0, 0, -1, 1, 0, 0, -1);
        builder.shorts(5122, "SCALAR", 3, "", -7, 0, 3);
        Mesh mesh = read(builder, ",\"JOINTS_0\":1,\"WEIGHTS_0\":2,\"TANGENT\":3,\"_TEMPERATURE\":4")
                .mesh();
        assertThat(names(mesh))
                .containsExactlyInAnyOrder("JOINTS_0", "WEIGHTS_0 normalized", "TANGENT", "_TEMPERATURE");
        assertThat(mesh.channels()).allMatch(channel -> channel.semantic() == Channel.Semantic.CUSTOM);
        assertThat(named(mesh, "JOINTS_0").type()).isEqualTo(Channel.Type.UINT8);
        assertThat(named(mesh, "WEIGHTS_0 normalized").type()).isEqualTo(Channel.Type.UINT16);
        assertThat(named(mesh, "_TEMPERATURE").type()).isEqualTo(Channel.Type.INT16);
        assertThat(at(mesh, "JOINTS_0", 0, 0)).containsExactly(1., 2., 3., 200.);
        assertThat(at(mesh, "WEIGHTS_0 normalized", 0, 0)).containsExactly(65535., 0., 0., 0.);
        assertThat(at(mesh, "TANGENT", 0, 1)).containsExactly(1., 0., 0., -1.);
        assertThat(at(mesh, "_TEMPERATURE", 0, 0)).containsExactly(-7.);
    }

    @Test
    void shouldKeepTheTypesOfQuantizedAttributes() throws IOException {
        GlbBuilder builder = bare();
        builder.bytes(5120, "VEC3", 3, NORMALIZED, 0, 0, 127, 0, 0, 127, 0, 0, -127);
        builder.shorts(5123, "VEC2", 3, NORMALIZED, 65535, 0, 1, 2, 3, 4);
        builder.shorts(5123, "VEC3", 3, NORMALIZED, 65535, 0, 1, 2, 3, 4, 5, 6, 7);
        builder.nodes("{\"mesh\":0,\"scale\":[2,2,2],\"translation\":[1,0,0]}");
        Mesh mesh =
                read(builder, ",\"NORMAL\":1,\"TEXCOORD_0\":2,\"COLOR_0\":3").mesh();
        assertThat(named(mesh, "NORMAL").type()).isEqualTo(Channel.Type.INT8);
        assertThat(named(mesh, "TEXCOORD_0").type()).isEqualTo(Channel.Type.UINT16);
        assertThat(named(mesh, "COLOR_0").type()).isEqualTo(Channel.Type.UINT16);
        assertThat(at(mesh, "NORMAL", 0, 2)).containsExactly(0., 0., -127.);
        assertThat(at(mesh, "TEXCOORD_0", 0, 0)).containsExactly(65535., 0.);
        assertThat(at(mesh, "COLOR_0", 0, 1)).containsExactly(2., 3., 4.);
    }

    @Test
    void shouldPutWholePositionsWhereTheirNodeDoes() throws IOException {
        GlbBuilder builder = new GlbBuilder();
        builder.shorts(5123, "VEC3", 3, "", 0, 0, 0, 60000, 0, 0, 0, 30000, 5);
        builder.nodes("{\"mesh\":0,\"scale\":[0.001,0.001,0.001],\"translation\":[-1,0,0]}");
        Mesh mesh = read(builder, "").mesh();
        assertThat(position(mesh, 0, 1)).containsExactly((double) (float) (60000 * .001 - 1), 0., 0.);
        assertThat(position(mesh, 0, 2)).containsExactly(-1., 30., (double) (float) (5 * .001));
    }

    @Test
    void shouldTakeNormalizedPositionsAsPartsOfTheirLargest() throws IOException {
        GlbBuilder builder = new GlbBuilder();
        builder.bytes(5120, "VEC3", 3, NORMALIZED, -128, 0, 0, 127, 0, 0, 0, 127, 0);
        Mesh mesh = read(builder, "").mesh();
        assertThat(position(mesh, 0, 0)).containsExactly(-1., 0., 0.);
        assertThat(position(mesh, 0, 1)).containsExactly(1., 0., 0.);
    }

    @Test
    void shouldTakeWholeTextureCoordinatesAsTheyAre() throws IOException {
        GlbBuilder builder = bare();
        builder.bytes(5121, "VEC2", 3, "", 0, 0, 3, 0, 0, 200);
        Mesh mesh = read(builder, ",\"TEXCOORD_0\":1").mesh();
        assertThat(named(mesh, "TEXCOORD_0").type()).isEqualTo(Channel.Type.FLOAT32);
        assertThat(at(mesh, "TEXCOORD_0", 0, 2)).containsExactly(0., 200.);
    }

    @Test
    void shouldTurnTangentsWithTheirNodeAndKeepTheirSide() throws IOException {
        GlbBuilder builder = bare();
        builder.bytes(5120, "VEC4", 3, NORMALIZED, 127, 0, 0, 127, 127, 0, 0, -127, 0, 127, 0, 127);
        // a quarter turn about z, and twice as long along the x axis of the mesh
        builder.nodes("{\"mesh\":0,\"matrix\":[0,2,0,0,-1,0,0,0,0,0,1,0,0,0,0,1]}");
        Mesh mesh = read(builder, ",\"TANGENT\":1").mesh();
        assertThat(named(mesh, "TANGENT").type()).isEqualTo(Channel.Type.FLOAT32);
        assertThat(at(mesh, "TANGENT", 0, 0)).containsExactly(0., 1., 0., 1.);
        assertThat(at(mesh, "TANGENT", 0, 1)).containsExactly(0., 1., 0., -1.);
        assertThat(at(mesh, "TANGENT", 0, 2)).containsExactly(-1., 0., 0., 1.);
    }

    @Test
    void shouldMakeFloatsOfNormalsThatANodeTurns() throws IOException {
        GlbBuilder builder = bare();
        builder.bytes(5120, "VEC3", 3, NORMALIZED, 127, 0, 0, 127, 0, 0, 0, 0, 127);
        builder.nodes("{\"mesh\":0,\"matrix\":[0,1,0,0,-1,0,0,0,0,0,1,0,0,0,0,1]}");
        Mesh mesh = read(builder, ",\"NORMAL\":1").mesh();
        assertThat(named(mesh, "NORMAL").type()).isEqualTo(Channel.Type.FLOAT32);
        assertThat(at(mesh, "NORMAL", 0, 0)).containsExactly(0., 1., 0.);
    }

    @Test
    void shouldHoldTypesThatDifferBetweenPrimitivesInOneChannel() throws IOException {
        GlbBuilder builder = bare();
        builder.bytes(5121, "VEC4", 3, "", 1, 2, 3, 4, 0, 0, 0, 0, 0, 0, 0, 0);
        builder.shorts(5123, "VEC4", 3, "", 1000, 2, 3, 4, 0, 0, 0, 0, 0, 0, 0, 0);
        Mesh mesh = builder.primitive("{\"attributes\":{\"POSITION\":0,\"JOINTS_0\":1}}")
                .primitive("{\"attributes\":{\"POSITION\":0,\"JOINTS_0\":2}}")
                .read()
                .mesh();
        assertThat(named(mesh, "JOINTS_0").type()).isEqualTo(Channel.Type.UINT16);
        assertThat(at(mesh, "JOINTS_0", 0, 0)).containsExactly(1., 2., 3., 4.);
        assertThat(at(mesh, "JOINTS_0", 1, 0)).containsExactly(1000., 2., 3., 4.);
    }

    @Test
    void shouldGiveEachChannelANameOfItsOwn() throws IOException {
        GlbBuilder builder = bare();
        builder.bytes(5121, "SCALAR", 3, NORMALIZED, 1, 2, 3);
        builder.bytes(5121, "SCALAR", 3, "", 4, 5, 6);
        Mesh mesh = read(builder, ",\"_A\":1,\"_A normalized\":2").mesh();
        assertThat(names(mesh)).containsExactly("_A normalized", "_A normalized'");
        assertThat(at(mesh, "_A normalized", 0, 1)).containsExactly(2.);
        assertThat(at(mesh, "_A normalized'", 0, 1)).containsExactly(5.);
    }

    @Test
    void shouldMarkWhatAPrimitiveLacksAsAbsent() throws IOException {
        GlbBuilder builder = GlbBuilder.triangle();
        Mesh mesh =
                builder.primitive("{\"attributes\":{\"POSITION\":0}}").read().mesh();
        assertThat(at(mesh, "NORMAL", 0, 0)).containsExactly(0., 0., 1.);
        assertThat(at(mesh, "NORMAL", 1, 0)).isNull();
    }

    @Test
    void shouldLeaveOutNormalsThatAreNoNumbers() throws IOException {
        GlbBuilder builder = bare();
        builder.floats("VEC3", 0, 0, 1, Float.NaN, 0, 1, 0, 0, Float.POSITIVE_INFINITY);
        ModelFile file = read(builder, ",\"NORMAL\":1");
        assertThat(at(file.mesh(), "NORMAL", 0, 0)).containsExactly(0., 0., 1.);
        assertThat(at(file.mesh(), "NORMAL", 0, 1)).isNull();
        assertThat(at(file.mesh(), "NORMAL", 0, 2)).isNull();
        assertThat(file.notes())
                .containsExactly(Note.dropped("The NORMAL of 2 vertices left out: not finite numbers.", 2, "vertex 1")
                        .asWarning());
    }

    @Test
    void shouldDropAttributesThatNoChannelHolds() throws IOException {
        GlbBuilder builder = bare();
        builder.floats("VEC4", new float[16]);
        builder.accessorText("{\"bufferView\":1,\"componentType\":5126,\"type\":\"MAT2\",\"count\":3}");
        ModelFile file = read(builder, ",\"_MATRIX\":2,\"_GONE\":77");
        assertThat(file.mesh().channels()).isEmpty();
        assertThat(file.notes())
                .containsExactly(Note.dropped(
                        "Vertex attributes of a kind or a length that does not fit dropped: _GONE, _MATRIX.",
                        2,
                        "_GONE"));
    }

    @Test
    void shouldWarnOfAttributesOfTheLookThatDoNotFit() throws IOException {
        GlbBuilder builder = bare();
        builder.floats("VEC2", 0, 0, 1, 1);
        builder.floats("VEC3", new float[9]);
        ModelFile file = read(builder, ",\"TEXCOORD_0\":1,\"TEXCOORD_1\":2");
        assertThat(file.mesh().channels()).isEmpty();
        assertThat(file.notes())
                .containsExactly(Note.dropped(
                                "Vertex attributes of a kind or a length that does not fit dropped: TEXCOORD_0, TEXCOORD_1.",
                                2,
                                "TEXCOORD_0")
                        .asWarning());
    }
}
