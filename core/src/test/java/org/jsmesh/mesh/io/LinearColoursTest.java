package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshIdentity;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Colours in linear light are written as a screen shows them, and that is told unless it changes nothing. */
class LinearColoursTest {
    private static Mesh mesh(Channel channel) {
        return new MeshBuilder()
                .positions(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0})
                .faceWedges(new int[] {0, 1, 2})
                .channels(List.of(channel))
                .build();
    }

    private static Channel colour(String name, int components, Channel.Type type, int... values) {
        return new Channel(Channel.Semantic.COLOUR, name, components, type, values, new BitSet());
    }

    private static int[] floats(float... values) {
        return MeshAssembler.bits(values);
    }

    private static List<String> write(Mesh mesh, ModelFormat format, List<Mesh> back) throws IOException {
        MemoryFiles files = new MemoryFiles();
        String name = "a." + format.extension();
        List<String> notes = ModelWriter.write(mesh, format, name, files);
        back.add(files.read(name).mesh());
        return notes;
    }

    @ParameterizedTest
    @EnumSource(names = {"PLY", "OBJ", "OFF"})
    void shouldWriteLevelsOfAScreen(ModelFormat format) throws IOException {
        // 0.21586 is the light of the level 128, 0.5 that of 188
        int[] light = floats(.21586f, 0, 1, .5f, -1, 2, 1, 1, 1);
        List<Mesh> back = new ArrayList<>();
        String told =
                format + " holds colours as a screen shows them: COLOR_0, in linear light, becomes levels of 8 bits.";
        assertThat(write(mesh(colour("COLOR_0", 3, Channel.Type.FLOAT32, light)), format, back))
                .containsExactly(told);
        Channel read = back.get(0).channels().get(0);
        assertThat(read.type()).isEqualTo(Channel.Type.UINT8);
        assertThat(read.values()).containsExactly(128, 0, 255, 188, 0, 255, 255, 255, 255);
    }

    @Test
    void shouldLeaveOpacityLinear() throws IOException {
        int[] light = floats(.21586f, 0, 1, .5f, .5f, .5f, .5f, 0, 1, 1, 1, 1);
        List<Mesh> back = new ArrayList<>();
        write(mesh(colour("COLOR_0", 4, Channel.Type.FLOAT32, light)), ModelFormat.PLY, back);
        assertThat(back.get(0).channels().get(0).values())
                .containsExactly(128, 0, 255, 128, 188, 188, 188, 0, 255, 255, 255, 255);
    }

    @Test
    void shouldTellNoLossWhereBlackAndWhiteStayTheSame() throws IOException {
        Mesh mesh = mesh(colour("COLOR_0", 3, Channel.Type.UINT8, 0, 255, 0, 255, 255, 255, 0, 0, 0));
        List<Mesh> back = new ArrayList<>();
        assertThat(write(mesh, ModelFormat.PLY, back)).isEmpty();
        assertThat(MeshIdentity.sha256(back.get(0))).isEqualTo(MeshIdentity.sha256(mesh));
    }

    @Test
    void shouldTellWhereColoursOfAScreenGetAnotherType() throws IOException {
        int[] values = {0, 1, 1, 0, 1, 0, 1, 1, 1};
        for (Channel.Type type : List.of(Channel.Type.UINT8, Channel.Type.UINT16)) {
            Mesh mesh = mesh(colour("colour", 3, type, values));
            for (ModelFormat format : List.of(ModelFormat.PLY, ModelFormat.OBJ, ModelFormat.OFF)) {
                List<Mesh> back = new ArrayList<>();
                boolean identical = write(mesh, format, back).isEmpty();
                assertThat(MeshIdentity.sha256(back.get(0)).equals(MeshIdentity.sha256(mesh)))
                        .as(format + " " + type)
                        .isEqualTo(identical);
            }
        }
    }

    @Test
    void shouldTellThatPlyPartsTheNumbersOfAnAttribute() throws IOException {
        Channel tangent = new Channel(
                Channel.Semantic.CUSTOM, "TANGENT", 4, Channel.Type.FLOAT32, floats(new float[12]), new BitSet());
        assertThat(write(mesh(tangent), ModelFormat.PLY, new ArrayList<>()))
                .containsExactly("PLY holds attributes by single numbers, and each number of these is one by itself:"
                        + " TANGENT.");
    }
}
