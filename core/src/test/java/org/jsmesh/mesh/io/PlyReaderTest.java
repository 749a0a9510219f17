package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.display.Slot;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class PlyReaderTest {
    @Test
    void shouldReadAsciiAndCutQuads() throws IOException {
        ModelFile file = Reading.read("a.ply", PlySamples.square("4 0 1 2 3"));
        assertThat(Reading.faces(file.mesh())).containsExactly("0,0,0 1,0,0 1,1,0", "0,0,0 1,1,0 0,1,0");
        assertThat(file.notes())
                .containsExactly(Note.changed(
                        "1 polygon with more than three corners cut into triangles, 0 of them concave.", 1, "face 0"));
        assertThat(file.format()).isEqualTo(ModelFormat.PLY);
    }

    @ParameterizedTest
    @CsvSource({
        "char,int8,1",
        "uchar,uint8,1",
        "short,int16,2",
        "ushort,uint16,2",
        "int,int32,4",
        "uint,uint32,4",
        "float,float32,4",
        "double,float64,8"
    })
    void shouldReadEveryScalarTypeInBothByteOrders(String name, String sizedName, int bytes) throws IOException {
        for (String type : new String[] {name, sizedName}) {
            for (ByteOrder order : new ByteOrder[] {ByteOrder.LITTLE_ENDIAN, ByteOrder.BIG_ENDIAN}) {
                Mesh mesh = ModelReader.read("a.ply", PlySamples.binary(type, order, bytes), ResourceResolver.NONE)
                        .mesh();
                assertThat(Reading.faces(mesh)).containsExactly("0,0,0 100,0,0 0,100,0");
            }
        }
    }

    @Test
    void shouldReadTriangleStripsAndDropTheirStitching() throws IOException {
        ModelFile file = Reading.read(
                "a.ply",
                "ply",
                "format ascii 1.0",
                "element vertex 5",
                "property float x",
                "property float y",
                "property float z",
                "element tristrips 1",
                "property list int int vertex_indices",
                "end_header",
                "0 0 0",
                "1 0 0",
                "0 1 0",
                "1 1 0",
                "5 5 5",
                "10 0 1 2 3 3 4 -1 0 1 4");
        assertThat(Reading.corners(file.mesh())).containsExactly(0, 1, 2, 2, 1, 3, 0, 1, 4);
        assertThat(file.notes())
                .containsExactly(Note.repaired("2 degenerate triangles that stitch strips dropped.", 2, ""));
    }

    @Test
    void shouldKeepDegenerateFaces() throws IOException {
        assertThat(Reading.corners(
                        Reading.read("a.ply", PlySamples.square("3 0 0 1")).mesh()))
                .containsExactly(0, 0, 1);
    }

    @Test
    void shouldSkipAndReportWhatItDoesNotKnow() throws IOException {
        ModelFile file = Reading.read(
                "a.ply",
                "ply",
                "format ascii 1.0",
                "comment hello",
                "obj_info hello",
                "element vertex 3",
                "property float x",
                "property list uchar float junk",
                "property float y",
                "property float z",
                "property float confidence",
                "element camera 1",
                "property float view",
                "property list uchar int l",
                "element face 1",
                "property uchar flags",
                "property list uchar int holes",
                "property list uchar int vertex_index",
                "end_header",
                "0 2 9 9 0 0 nan",
                "1 0 0 0 1",
                "0 0 1 0 1",
                "7",
                "1 1",
                "4 0 3 0 1 2");
        assertThat(Reading.faces(file.mesh())).containsExactly("0,0,0 1,0,0 0,1,0");
        assertThat(file.notes())
                .containsExactly(
                        Note.dropped("The confidence of 1 vertex left out: not finite numbers.", 1, "vertex 0"),
                        Note.unread("Vertex properties skipped: junk.", 1, "junk"),
                        Note.unread("Properties of face skipped: holes.", 1, "holes"),
                        Note.unread("Elements skipped: camera.", 1, "camera"));
    }

    @Test
    void shouldWeldVerticesThatDifferOnlyInAttributes() throws IOException {
        Mesh mesh = Reading.read(
                        "a.ply",
                        "ply",
                        "format ascii 1.0",
                        "element vertex 6",
                        "property float x",
                        "property float y",
                        "property float z",
                        "property float s",
                        "property float t",
                        "property uchar red",
                        "property uchar green",
                        "property uchar blue",
                        "element face 2",
                        "property list uchar int vertex_indices",
                        "end_header",
                        "0 0 0 0 0 1 2 3",
                        "1 0 0 1 0 1 2 3",
                        "0 1 0 0 1 1 2 3",
                        "0 1 0 0 1 1 2 3",
                        "1 0 0 .5 0 1 2 3",
                        "1 1 0 1 1 255 2 3",
                        "3 0 1 2",
                        "3 3 4 5")
                .mesh();
        assertThat(mesh.vertices()).isEqualTo(4);
        assertThat(mesh.wedges()).isEqualTo(5);
        assertThat(mesh.channels()).extracting(Channel::name).containsExactly("uv", "colour");
        assertThat(mesh.channel(Channel.Semantic.COLOUR).type()).isEqualTo(Channel.Type.UINT8);
        assertThat(mesh.vertex(0, 1)).isEqualTo(mesh.vertex(1, 1));
        assertThat(Reading.at(mesh, Channel.Semantic.TEXCOORD, 0, 1)).containsExactly(1, 0);
        assertThat(Reading.at(mesh, Channel.Semantic.TEXCOORD, 1, 1)).containsExactly(.5f, 0);
        assertThat(Reading.at(mesh, Channel.Semantic.COLOUR, 1, 2)).containsExactly(1, 2 / 255f, 3 / 255f);
    }

    @Test
    void shouldNotWeldVerticesWithoutAttributes() throws IOException {
        String[] lines = PlySamples.square("3 0 1 2");
        lines[12] = "0 0 0";
        assertThat(Reading.read("a.ply", lines).mesh().vertices()).isEqualTo(4);
    }

    @ParameterizedTest
    @ValueSource(strings = {"s t", "u v", "texture_u texture_v"})
    void shouldKnowEveryNameOfTextureCoordinates(String names) throws IOException {
        String[] lines = PlySamples.square("3 0 1 2");
        lines[5] =
                "property float z\nproperty float " + names.split(" ")[0] + "\nproperty float " + names.split(" ")[1];
        for (int i = 9; i < 13; i++) lines[i] += " 0.25 0.5";
        Mesh mesh = Reading.read("a.ply", lines).mesh();
        assertThat(Reading.at(mesh, Channel.Semantic.TEXCOORD, 0, 2)).containsExactly(.25f, .5f);
    }

    @Test
    void shouldReadColoursOfFloatsWithAlpha() throws IOException {
        String[] lines = PlySamples.square("3 0 1 2");
        lines[5] =
                "property float z\nproperty float red\nproperty float green\nproperty float blue\nproperty float alpha";
        for (int i = 9; i < 13; i++) lines[i] += " 0.1 0.2 0.3 0.4";
        Mesh mesh = Reading.read("a.ply", lines).mesh();
        assertThat(Reading.at(mesh, Channel.Semantic.COLOUR, 0, 2)).containsExactly(.1f, .2f, .3f, .4f);
        assertThat(mesh.channel(Channel.Semantic.COLOUR).type()).isEqualTo(Channel.Type.FLOAT32);
    }

    @Test
    void shouldReadTextureCoordinatesOfFaceCornersAndTextureFiles() throws IOException {
        byte[] content = Reading.bytes(
                "ply",
                "format ascii 1.0",
                "comment TextureFile my wood.png",
                "element vertex 3",
                "property float x",
                "property float y",
                "property float z",
                "element face 2",
                "property list uchar int vertex_indices",
                "property list uchar float texcoord",
                "end_header",
                "0 0 0",
                "1 0 0",
                "0 1 0",
                "3 0 1 2 6 0 0 1 0 0 1",
                "3 2 1 0 0");
        ModelFile file = ModelReader.read("a.ply", content, new MemoryFiles().with("my wood.png", "PNG"));
        assertThat(Reading.at(file.mesh(), Channel.Semantic.TEXCOORD, 0, 1)).containsExactly(1, 0);
        assertThat(Reading.at(file.mesh(), Channel.Semantic.TEXCOORD, 1, 1)).isNull();
        assertThat(DisplayMaterial.of(file.mesh().materials().get(0), false).image(Slot.COLOUR))
                .isEqualTo("my wood.png");
        assertThat(file.mesh().textures().get(0).bytes()).asString().isEqualTo("PNG");
    }

    @Test
    void shouldKeepDoubles() throws IOException {
        String[] lines = PlySamples.square("3 0 1 2");
        lines[3] = "property double x";
        lines[10] = "0.1 0 0";
        ModelFile file = Reading.read("a.ply", lines);
        assertThat(file.mesh().coordinate(1, 0)).isEqualTo(.1);
        assertThat(file.notes()).isEmpty();
    }

    @Test
    void shouldRoundDecimalTextOfFloatsWithoutANote() throws IOException {
        String[] lines = PlySamples.square("3 0 1 2");
        lines[10] = "0.1 -0 1e-45";
        ModelFile file = Reading.read("a.ply", lines);
        assertThat(file.mesh().positions()).contains(.1f, -0f, Float.MIN_VALUE);
        assertThat(Float.floatToRawIntBits(file.mesh().positions()[4])).isEqualTo(0x80000000);
        assertThat(file.notes()).isEmpty();
    }

    @Test
    void shouldTakeDataBehindACarriageReturnAlone() throws IOException {
        byte[] lf = PlySamples.binary("float", ByteOrder.LITTLE_ENDIAN, 4);
        String text = new String(lf, StandardCharsets.ISO_8859_1);
        int end = text.indexOf("end_header\n") + 11;
        String header = text.substring(0, end).replace('\n', '\r').replace("element vertex", "element vertex");
        // first data byte is a line feed: 1.4e-44 as float
        String data = "\n" + text.substring(end + 1);
        Mesh mesh = ModelReader.read(
                        "a.ply", (header + data).getBytes(StandardCharsets.ISO_8859_1), ResourceResolver.NONE)
                .mesh();
        assertThat(Float.floatToRawIntBits(mesh.positions()[0])).isEqualTo(10);
    }
}
