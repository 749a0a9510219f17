package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshComparison;
import org.jsmesh.mesh.Note;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ObjColoursTest {
    private static final String FACE = "f 1 2 3";

    private static ModelFile read(String... lines) throws IOException {
        return Reading.read("a.obj", lines);
    }

    private static float[] colour(Mesh mesh, int corner) {
        return Reading.at(mesh, Channel.Semantic.COLOUR, 0, corner);
    }

    @Test
    void shouldKeepColoursFrom0To255AsTheyAre() throws IOException {
        Mesh mesh = read("v 0 0 0 127 127 255", "v 1 0 0 1 0 0", "v 0 1 0 0 0 0", FACE)
                .mesh();
        assertThat(mesh.channel(Channel.Semantic.COLOUR).type()).isEqualTo(Channel.Type.FLOAT32);
        assertThat(colour(mesh, 0)).containsExactly(127, 127, 255);
        assertThat(colour(mesh, 1)).containsExactly(1, 0, 0);
    }

    @Test
    void shouldBeOpaqueInTheRangeOfTheOtherNumbers() throws IOException {
        Mesh mesh = read("v 0 0 0 127 127 255", "v 1 0 0 1 0 0 128", "v 0 1 0 0 0 0", FACE)
                .mesh();
        assertThat(colour(mesh, 0)).containsExactly(127, 127, 255, 255);
        assertThat(colour(mesh, 1)).containsExactly(1, 0, 0, 128);
        Mesh deep = read("v 0 0 0 127 127 65535", "v 1 0 0 1 0 0 128", "v 0 1 0 0 0 0", FACE)
                .mesh();
        assertThat(colour(deep, 0)).containsExactly(127, 127, 65535, 65535);
    }

    @ParameterizedTest
    @ValueSource(strings = {"nan 0 0", "0 inf 0", "red green blue", "0 0 1e99"})
    void shouldLeaveOutAColourThatIsNone(String colour) throws IOException {
        ModelFile file = read("v 0 0 0 1 0 .5", "v 1 0 0 " + colour, "v 0 1 0 0 0 0", FACE);
        assertThat(colour(file.mesh(), 0)).containsExactly(1, 0, .5f);
        assertThat(colour(file.mesh(), 1)).isNull();
        assertThat(colour(file.mesh(), 2)).containsExactly(0, 0, 0);
        assertThat(file.notes())
                .containsExactly(Note.dropped("1 colour of vertices not finite, left out.", 1, "line 2")
                        .asWarning());
    }

    @Test
    void shouldReadPolypaintAsColoursOf8BitsGoingOnFromLineToLine() throws IOException {
        ModelFile file = read("v 0 0 0", "v 1 0 0", "v 0 1 0", "#MRGB ffff8000ff010203", "#MRGB FFfffefd", FACE);
        assertThat(file.mesh().channel(Channel.Semantic.COLOUR).type()).isEqualTo(Channel.Type.UINT8);
        assertThat(file.mesh().channel(Channel.Semantic.COLOUR).values())
                .containsExactly(255, 128, 0, 1, 2, 3, 255, 254, 253);
        assertThat(file.notes()).isEmpty();
    }

    @Test
    void shouldTellWhatOfPolypaintIsNotInTheColours() throws IOException {
        ModelFile file = read("#MRGB 80ff8000ff010203ff00", "v 0 0 0", "v 1 0 0", "v 0 1 0", FACE);
        assertThat(colour(file.mesh(), 1)).containsExactly(1 / 255f, 2 / 255f, 3 / 255f);
        assertThat(colour(file.mesh(), 2)).isNull();
        assertThat(file.notes())
                .containsExactly(
                        Note.dropped("1 line #MRGB not whole, read as far as it is hexadecimal.", 1, "line 1"),
                        Note.dropped("Masks of lines #MRGB not kept, their colours are.", 1, "line 1"),
                        Note.repaired("Lines #MRGB have no colour for the last 1 vertex.", 1, "vertex 2"));
        assertThat(read("v 0 0 0", "v 1 0 0", "v 0 1 0", "#MRGB " + "ff010203".repeat(5), FACE)
                        .notes())
                .containsExactly(
                        Note.dropped("2 colours of lines #MRGB left over behind the last vertex.", 2, "#MRGB"));
    }

    @Test
    void shouldTakeTheColoursOfLinesVWherePolypaintSaysOtherOnes() throws IOException {
        String[] vertices = {"v 0 0 0 1 0 0", "v 1 0 0 1 0 0", "v 0 1 0 1 0 0"};
        ModelFile file = read(vertices[0], vertices[1], vertices[2], "#MRGB " + "ff010203".repeat(3), FACE);
        assertThat(colour(file.mesh(), 1)).containsExactly(1, 0, 0);
        assertThat(file.notes())
                .containsExactly(
                        Note.dropped("Colours of lines #MRGB left out, because lines v have other ones.", 3, "#MRGB")
                                .asWarning());
    }

    @Test
    void shouldWriteColoursOf8BitsForEveryProgramAndReadTheirTypeBack() throws IOException {
        String[] lines = new String[202];
        for (int i = 0; i < 200; i++) lines[i] = "v " + i + " " + i * i + " 1";
        lines[200] = "#MRGB " + "ff8040c0".repeat(199) + "ff000001";
        lines[201] = "f 1 2 3\nf 198 199 200";
        Mesh mesh = read(lines).mesh();
        MemoryFiles files = new MemoryFiles();
        List<String> notes = ModelWriter.write(mesh, ModelFormat.OBJ, "b.obj", files);
        assertThat(notes).isEmpty();
        assertThat(files.text("b.obj")).contains("v 0 0 1 0.5019608 0.2509804 0.7529412\n");
        assertThat(files.text("b.obj").lines().filter(line -> line.startsWith("#MRGB ")))
                .allMatch(line -> line.length() <= 6 + 8 * 64)
                .isNotEmpty();
        ModelFile again = files.read("b.obj");
        assertThat(again.notes()).isEmpty();
        assertThat(MeshComparison.firstDifference(mesh, again.mesh())).isEmpty();
    }

    @Test
    void shouldSayThatOpacityOf8BitsOrAGapComesBackAsNumbers() throws IOException {
        Mesh gap = read("v 0 0 0", "v 1 0 0", "v 0 1 0", "#MRGB ffff8000ff010203", FACE)
                .mesh();
        MemoryFiles files = new MemoryFiles();
        assertThat(ModelWriter.write(gap, ModelFormat.OBJ, "b.obj", files))
                .containsExactly("OBJ holds colours of 8 bits with opacity or gaps as numbers from 0 to 1.");
        assertThat(colour(files.read("b.obj").mesh(), 2)).isNull();
    }
}
