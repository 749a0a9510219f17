package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.display.Slot;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshComparison;
import org.jsmesh.mesh.Note;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Colours of vertices and faces of PLY files, of every type, and attributes that are no finite numbers. */
class PlyColoursTest {
    private static final String RGB = "\nproperty %1$s red\nproperty %1$s green\nproperty %1$s blue";

    private static String[] vertexColours(String type, String colour) {
        String[] lines = PlySamples.square("3 0 1 2");
        lines[5] += RGB.formatted(type);
        for (int i = 9; i < 13; i++) lines[i] += ' ' + colour;
        return lines;
    }

    private static String[] faceColours(String type, String... faces) {
        String[] lines = PlySamples.square(faces);
        lines[6] = "element face " + faces.length;
        lines[7] += RGB.formatted(type);
        return lines;
    }

    @ParameterizedTest
    @CsvSource({
        "uchar,0 51 255,0,.2,1,UINT8",
        "ushort,0 13107 65535,0,.2,1,UINT16",
        "char,0 51 127,0,.401574803,1,INT8",
        "short,-1 0 32767,-.000030518509,0,1,INT16",
        "int,0 51 255,0,51,255,INT32",
        "uint,0 13107 4294967295,0,13107,4294967295,UINT32",
        "int64,0 51 255,0,51,255,INT32",
        "float,0 .2 1,0,.2,1,FLOAT32",
        "double,0 .5 1,0,.5,1,FLOAT32"
    })
    void shouldReadColoursOfVerticesOfEveryTypeAndKeepIt(
            String type, String text, float r, float g, float b, Channel.Type kept) throws IOException {
        ModelFile file = Reading.read("a.ply", vertexColours(type, text));
        assertThat(file.mesh().channel(Channel.Semantic.COLOUR).type()).isEqualTo(kept);
        MemoryFiles files = new MemoryFiles();
        assertThat(ModelWriter.write(file.mesh(), ModelFormat.PLY, "b.ply", files))
                .isEmpty();
        assertThat(MeshComparison.firstDifference(
                        file.mesh(), files.read("b.ply").mesh()))
                .isEmpty();
        assertThat(Reading.at(file.mesh(), Channel.Semantic.COLOUR, 0, 1)).containsExactly(r, g, b);
        assertThat(file.notes()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({
        "uchar,0 51 255,0,.2,1",
        "ushort,0 13107 65535,0,.2,1",
        "int,0 51 255,0,.2,1",
        "int,0 13107 65535,0,.2,1",
        "float,0 .2 1,0,.2,1",
        "float,0 51 255,0,.2,1",
        "double,0 .5 1,0,.5,1"
    })
    void shouldMakeAMaterialOfEachColourOfFaces(String type, String text, float r, float g, float b)
            throws IOException {
        ModelFile file =
                Reading.read("a.ply", faceColours(type, "3 0 1 2 " + text, "3 0 2 3 1 1 1", "3 1 2 3 " + text));
        Mesh mesh = file.mesh();
        assertThat(mesh.faceMaterials()).containsExactly(0, 1, 0);
        assertThat(mesh.materials()).hasSize(2);
        assertThat(mesh.materials().get(0).parameter("rgb")).containsExactly(r, g, b);
        assertThat(file.notes()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"uchar", "ushort", "float"})
    void shouldWriteColoursOfFacesBack(String type) throws IOException {
        Mesh mesh = Reading.read("a.ply", faceColours(type, "3 0 1 2 1 0 0", "3 0 2 3 0 0 1", "3 1 2 3 0 0 1"))
                .mesh();
        MemoryFiles files = new MemoryFiles();
        assertThat(ModelWriter.write(mesh, ModelFormat.PLY, "b.ply", files)).isEmpty();
        assertThat(files.text("b.ply")).contains(RGB.formatted(type.equals("float") ? "uchar" : type));
        ModelFile again = files.read("b.ply");
        assertThat(MeshComparison.firstDifference(mesh, again.mesh())).isEmpty();
        assertThat(again.notes()).isEmpty();
    }

    @Test
    void shouldKeepOpacityAndTextureBesideTheColourOfAFace() throws IOException {
        String[] lines = faceColours("float", "3 0 1 2 .1 0 0 .5 0", "3 0 2 3 .1 0 0 .5 1", "3 1 2 3 1 1 1 1 0");
        lines[1] += "\ncomment TextureFile a.png\ncomment TextureFile b.png";
        lines[7] += "\nproperty float alpha\nproperty int texnumber";
        MemoryFiles files = new MemoryFiles().with("a.png", "A").with("b.png", "B");
        Mesh mesh = ModelReader.read("a.ply", Reading.bytes(lines), files).mesh();
        assertThat(mesh.faceMaterials()).containsExactly(0, 1, 2);
        assertThat(mesh.materials())
                .extracting(m -> DisplayMaterial.of(m, false).image(Slot.COLOUR))
                .containsExactly("a.png", "b.png", "a.png");
        assertThat(DisplayMaterial.of(mesh.materials().get(1), false).plain()).containsExactly(.1f, 0, 0, .5f);
        MemoryFiles written = new MemoryFiles();
        assertThat(ModelWriter.write(mesh, ModelFormat.PLY, "c.ply", written)).isEmpty();
        assertThat(MeshComparison.firstDifference(mesh, written.read("c.ply").mesh()))
                .isEmpty();
    }

    @Test
    void shouldSayWhatPlyHasNoMarkFor() throws IOException {
        Mesh mesh = Reading.read("a.off", "OFF", "3 2 0", "0 0 0", "1 0 0", "0 1 0", "3 0 1 2", "3 0 1 2 255 0 0")
                .mesh();
        MemoryFiles files = new MemoryFiles();
        assertThat(ModelWriter.write(mesh, ModelFormat.PLY, "b.ply", files))
                .containsExactly("PLY gives all faces a colour or none: where there is none, white is written.");
        assertThat(files.read("b.ply").mesh().materials().get(0).parameter("rgb"))
                .containsExactly(1, 1, 1);
    }

    @Test
    void shouldKeepManyColoursOfFacesByCorner() throws IOException {
        List<String> faces = new ArrayList<>();
        int colours = FaceColours.MOST_MATERIALS + 1;
        for (int i = 0; i < colours; i++) faces.add("3 0 1 2 " + i % 256 + ' ' + i / 256 + " 7");
        ModelFile file = Reading.read("a.ply", faceColours("uchar", faces.toArray(String[]::new)));
        Mesh mesh = file.mesh();
        assertThat(mesh.materials()).isEmpty();
        assertThat(Reading.at(mesh, Channel.Semantic.COLOUR, 1000, 2))
                .containsExactly(1000 % 256 / 255f, 3 / 255f, 7 / 255f);
        assertThat(file.notes())
                .containsExactly(Note.changed("1025 colours of faces kept as colours of their corners.", 1025, ""));
        MemoryFiles files = new MemoryFiles();
        assertThat(ModelWriter.write(mesh, ModelFormat.PLY, "b.ply", files)).isEmpty();
        assertThat(MeshComparison.firstDifference(mesh, files.read("b.ply").mesh()))
                .isEmpty();
    }

    @Test
    void shouldLeaveOutAttributesThatAreNotFiniteWhereTheyAre() throws IOException {
        String[] lines = PlySamples.square("3 0 1 2");
        lines[5] += "\nproperty float nx\nproperty float ny\nproperty float nz\nproperty float s\nproperty float t"
                + RGB.formatted("float");
        String[] values = {" 0 0 1 0 0 1 1 1", " nan 0 1 0 0 1 1 1", " 0 0 1 0 inf 1 1 1", " 0 0 1 0 0 1 1 nan"};
        for (int i = 0; i < 4; i++) lines[9 + i] += values[i];
        lines[13] = "4 0 1 2 3";
        ModelFile file = Reading.read("a.ply", lines);
        assertThat(file.notes())
                .contains(
                        Note.dropped("The normal of 1 vertex left out: not finite numbers.", 1, "vertex 1")
                                .asWarning(),
                        Note.dropped("The uv of 1 vertex left out: not finite numbers.", 1, "vertex 2")
                                .asWarning(),
                        Note.dropped("The colour of 1 vertex left out: not finite numbers.", 1, "vertex 3")
                                .asWarning());
        assertThat(Reading.at(file.mesh(), Channel.Semantic.NORMAL, 0, 1)).isNull();
        assertThat(Reading.at(file.mesh(), Channel.Semantic.NORMAL, 0, 0)).containsExactly(0, 0, 1);
        assertThat(Reading.at(file.mesh(), Channel.Semantic.TEXCOORD, 0, 2)).isNull();
        assertThat(Reading.at(file.mesh(), Channel.Semantic.COLOUR, 1, 2)).isNull();
    }

    @Test
    void shouldLeaveOutColoursAndTextureCoordinatesOfFacesThatAreNotFinite() throws IOException {
        String[] lines = faceColours("float", "3 0 1 2 nan 0 0 6 0 0 nan 0 1 1", "3 0 2 3 1 0 0 6 0 0 1 0 1 1");
        lines[7] += "\nproperty list uchar float texcoord";
        ModelFile file = Reading.read("a.ply", lines);
        assertThat(file.mesh().faceMaterials()).containsExactly(-1, 0);
        assertThat(Reading.at(file.mesh(), Channel.Semantic.TEXCOORD, 0, 1)).isNull();
        assertThat(Reading.at(file.mesh(), Channel.Semantic.TEXCOORD, 0, 2)).containsExactly(1, 1);
        assertThat(file.notes())
                .containsExactly(
                        Note.dropped(
                                        "The texture coordinates of 1 corner of a face left out: not finite numbers.",
                                        1,
                                        "face 0")
                                .asWarning(),
                        Note.dropped("The colour of 1 face left out: not finite numbers.", 1, "face 0")
                                .asWarning());
    }

    @Test
    void shouldKeepColoursOfVerticesBesideThoseOfFaces() throws IOException {
        String[] lines = vertexColours("uchar", "1 2 3");
        lines[7] += RGB.formatted("uchar");
        lines[13] += " 255 0 0";
        Mesh mesh = Reading.read("a.ply", lines).mesh();
        assertThat(mesh.materials().get(0).parameter("rgb")).containsExactly(1, 0, 0);
        assertThat(mesh.channels()).extracting(Channel::name).containsExactly("colour");
        assertThat(Arrays.stream(mesh.channel(Channel.Semantic.COLOUR).values()).limit(3))
                .containsExactly(1, 2, 3);
    }
}
