package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Arrays;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** OFF files in the dialects of their programs: headers, orders, colours. */
class OffDialectsTest {
    private static ModelFile read(String lines) throws IOException {
        return Reading.read("a.off", lines.split("/"));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "OFF3 1 0",
                "OFF3/1/0",
                "OFF/3/1/0",
                "OFF/3 1/0",
                "OFF/3/1 0",
                "OFF # a/# b/3 # c/# d/1/# e/0",
                "off3 1 0",
                "OFF/3 1",
                "OFF/3/1",
                "OFF 3/1 0 # c"
            })
    void shouldReadCountsWhereverTheyAre(String header) throws IOException {
        ModelFile file = read(header + "/0 0 0/# c/1 0 0/0 1 0/3 0 1 2");
        assertThat(Reading.faces(file.mesh())).containsExactly("0,0,0 1,0,0 0,1,0");
        assertThat(file.notes()).isEmpty();
        assertThat(file.format()).isEqualTo(ModelFormat.OFF);
    }

    @ParameterizedTest
    @CsvSource({
        "NOFF,0 0 1",
        "noff,0 0 1",
        "COFF,10 20 30",
        "STOFF,.25 .5",
        "CNOFF,0 0 1 10 20 30",
        "NCOFF,0 0 1 10 20 30",
        "NCOFF,10 20 30 0 0 1",
        "CNOFF,10 20 30 255 0 0 1",
        "STNOFF,0 0 1 .25 .5",
        "NSTOFF,0 0 1 .25 .5",
        "CSTOFF,10 20 30 .25 .5",
        "STCNOFF,0 0 1 10 20 30 .25 .5",
        "NCSTOFF,10 20 30 255 0 0 1 .25 .5",
        "STNCOFF3,0 0 1 10 20 30 .25 .5"
    })
    void shouldReadAttributesInEveryOrder(String keyword, String attributes) throws IOException {
        String counts = keyword.endsWith("3") ? " 1 0" : "/3 1 0";
        String rest = ' ' + attributes + '/';
        Mesh mesh = read(keyword + counts + "/0 0 0" + rest + "1 0 0" + rest + "0 1 0" + rest + "3 0 1 2")
                .mesh();
        assertThat(Reading.faces(mesh)).containsExactly("0,0,0 1,0,0 0,1,0");
        boolean normals = keyword.toUpperCase(java.util.Locale.ROOT).contains("N");
        assertThat(mesh.channel(Channel.Semantic.NORMAL) != null).isEqualTo(normals);
        assertThat(mesh.channel(Channel.Semantic.COLOUR) != null).isEqualTo(keyword.contains("C"));
        assertThat(mesh.channel(Channel.Semantic.TEXCOORD) != null).isEqualTo(keyword.contains("ST"));
        for (Channel channel : mesh.channels()) {
            float[] first = Arrays.copyOf(Reading.at(mesh, channel.semantic(), 0, 1), channel.components());
            switch (channel.semantic()) {
                case NORMAL -> assertThat(first).containsExactly(0, 0, 1);
                case COLOUR -> assertThat(first).startsWith(10 / 255f, 20 / 255f, 30 / 255f);
                default -> assertThat(first).containsExactly(.25f, .5f);
            }
        }
    }

    @Test
    void shouldTellOfFacesBehindTheLastCountedOne() throws IOException {
        ModelFile file = read("OFF/3 1 0/0 0 0/1 0 0/0 1 0/3 0 1 2/3 2 1 0/# c/3 0 2 1");
        assertThat(file.mesh().faces()).isEqualTo(1);
        assertThat(file.notes()).containsExactly(Note.unread("2 rows behind the last face skipped.", 2, "line 7"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "255 0 51|1 1 1|1,0,.2",
                "1 0 0|0 1 0|1,0,0",
                "1 0 0|0 255 0|.003921569,0,0",
                "1. 0 .5|255 0 51|1,0,.5",
                "0 127.5 255.|0 0 0|0,.5,1"
            })
    void shouldTellFloatsFromBytesByFace(String first, String second, String rgb) throws IOException {
        Mesh mesh = read("OFF/3 2 0/0 0 0/1 0 0/0 1 0/3 0 1 2 " + first + "/3 2 1 0 " + second)
                .mesh();
        String[] expected = rgb.split(",");
        float[] colour = mesh.materials().get(0).parameter("rgb");
        for (int i = 0; i < 3; i++) assertThat(colour[i]).isEqualTo(Float.parseFloat(expected[i]));
    }

    @Test
    void shouldGiveTheSameNumberOfAColourTableTheSameColour() throws IOException {
        ModelFile file = read("OFF/3 4 0/0 0 0/1 0 0/0 1 0/3 0 1 2 7/3 0 1 2 8/3 0 1 2 7/3 0 1 2");
        assertThat(file.mesh().faceMaterials()).containsExactly(0, 1, 0, -1);
        Material seven = file.mesh().materials().get(0);
        assertThat(seven.parameter("rgb")).containsExactly(ColourTable.colour(7));
        assertThat(file.notes()).singleElement().satisfies(note -> {
            assertThat(note.kind()).isEqualTo(Note.Kind.CHANGED);
            assertThat(note.count()).isEqualTo(3);
            assertThat(note.example()).isEqualTo("face 0");
        });
    }

    @Test
    void shouldGiveVerticesColoursOfATableToo() throws IOException {
        ModelFile file = read("COFF/3 1 0/0 0 0 7/1 0 0 7/0 1 0 9/3 0 1 2");
        assertThat(Reading.at(file.mesh(), Channel.Semantic.COLOUR, 0, 2)).containsExactly(ColourTable.colour(9));
        assertThat(file.notes()).extracting(Note::kind).containsExactly(Note.Kind.CHANGED);
    }

    @Test
    void shouldTellNumbersBehindAFaceThatAreNoColour() throws IOException {
        ModelFile file = read("OFF/3 1 0/0 0 0/1 0 0/0 1 0/3 0 1 2 5 6");
        assertThat(file.notes())
                .containsExactly(Note.unread("Numbers behind 1 face that are no colour skipped.", 1, "face 0"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "1 0 0|0 0 1|FLOAT32|0,0,1",
                "1 0 0|0 0 255|UINT8|0,0,1",
                "1 0 0|0 0 65535|UINT16|0,0,1",
                "1 0 0|0 0 .5|FLOAT32|0,0,.5",
                "1 0 .5|0 0 255|FLOAT32|0,0,1"
            })
    void shouldTellWhatColoursOfVerticesCountUpTo(String first, String last, Channel.Type type, String rgb)
            throws IOException {
        Mesh mesh = read("COFF/3 1 0/0 0 0 " + first + "/1 0 0 0 0 0/0 1 0 " + last + "/3 0 1 2")
                .mesh();
        assertThat(mesh.channel(Channel.Semantic.COLOUR).type()).isEqualTo(type);
        float[] colour = Reading.at(mesh, Channel.Semantic.COLOUR, 0, 2);
        String[] expected = rgb.split(",");
        for (int i = 0; i < 3; i++) assertThat(colour[i]).isEqualTo(Float.parseFloat(expected[i]));
    }

    @Test
    void shouldLeaveOutAttributesThatAreNotFiniteWhereTheyAre() throws IOException {
        ModelFile file = read("STCNOFF/3 1 0/0 0 0 nan 0 1 9 9 9 0 0/1 0 0 0 0 1 9 inf 9 0 0/"
                + "0 1 0 0 0 1 9 9 9 1e99 0/3 0 1 2 nan 0 0");
        Mesh mesh = file.mesh();
        assertThat(Reading.at(mesh, Channel.Semantic.NORMAL, 0, 0)).isNull();
        assertThat(Reading.at(mesh, Channel.Semantic.NORMAL, 0, 1)).containsExactly(0, 0, 1);
        assertThat(Reading.at(mesh, Channel.Semantic.COLOUR, 0, 1)).isNull();
        assertThat(Reading.at(mesh, Channel.Semantic.TEXCOORD, 0, 2)).isNull();
        assertThat(mesh.faceMaterials()).containsExactly(-1);
        assertThat(file.notes())
                .containsExactlyInAnyOrder(
                        Note.dropped("The normal of 1 vertex left out: not finite numbers.", 1, "vertex 0")
                                .asWarning(),
                        Note.dropped("The colour of 1 vertex left out: not finite numbers.", 1, "vertex 1")
                                .asWarning(),
                        Note.dropped("The uv of 1 vertex left out: not finite numbers.", 1, "vertex 2")
                                .asWarning(),
                        Note.dropped("The colour of 1 face left out: not finite numbers.", 1, "face 0")
                                .asWarning());
    }
}
