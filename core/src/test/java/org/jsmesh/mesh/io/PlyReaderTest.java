package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class PlyReaderTest {
    private static final String[] SQUARE = {
        "ply",
        "format ascii 1.0",
        "element vertex 4",
        "property float x",
        "property float y",
        "property float z",
        "element face 1",
        "property list uchar int vertex_indices",
        "end_header",
        "0 0 0",
        "1 0 0",
        "1 1 0",
        "0 1 0"
    };

    private static String[] square(String... faceLines) {
        String[] all = java.util.Arrays.copyOf(SQUARE, SQUARE.length + faceLines.length);
        System.arraycopy(faceLines, 0, all, SQUARE.length, faceLines.length);
        return all;
    }

    @Test
    void shouldReadAsciiAndCutQuads() throws IOException {
        ModelFile file = Reading.read("a.ply", square("4 0 1 2 3"));
        assertThat(Reading.faces(file.mesh())).containsExactly("0,0,0 1,0,0 1,1,0", "0,0,0 1,1,0 0,1,0");
        assertThat(file.notes())
                .containsExactly("1 polygon with more than three corners cut into triangles, 0 of them concave.");
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
                Mesh mesh = ModelReader.read("a.ply", binary(type, order, bytes), ResourceResolver.NONE)
                        .mesh();
                assertThat(Reading.faces(mesh)).containsExactly("0,0,0 100,0,0 0,100,0");
            }
        }
    }

    private static byte[] binary(String type, ByteOrder order, int bytes) throws IOException {
        String header = "ply\nformat binary_" + (order == ByteOrder.LITTLE_ENDIAN ? "little" : "big")
                + "_endian 1.0\nelement vertex 3\nproperty " + type + " x\nproperty " + type + " y\nproperty " + type
                + " z\nelement face 1\nproperty list ushort int vertex_indices\nend_header\n";
        ByteBuffer data = ByteBuffer.allocate(9 * bytes + 2 + 12).order(order);
        for (int i = 0; i < 9; i++) {
            int value = i == 3 || i == 7 ? 100 : 0;
            switch (type) {
                case "char", "uchar", "int8", "uint8" -> data.put((byte) value);
                case "short", "ushort", "int16", "uint16" -> data.putShort((short) value);
                case "int", "uint", "int32", "uint32" -> data.putInt(value);
                case "float", "float32" -> data.putFloat(value);
                default -> data.putDouble(value);
            }
        }
        data.putShort((short) 3).putInt(0).putInt(1).putInt(2);
        return join(header.getBytes(StandardCharsets.US_ASCII), data.array());
    }

    private static byte[] join(byte[] a, byte[] b) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(a);
        out.writeBytes(b);
        return out.toByteArray();
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
        assertThat(file.notes()).containsExactly("2 degenerate triangles that stitch strips dropped.");
    }

    @Test
    void shouldKeepDegenerateFaces() throws IOException {
        assertThat(Reading.corners(Reading.read("a.ply", square("3 0 0 1")).mesh()))
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
                "property list uchar int vertex_index",
                "end_header",
                "0 2 9 9 0 0 nan",
                "1 0 0 0 1",
                "0 0 1 0 1",
                "7",
                "1 1",
                "4 3 0 1 2");
        assertThat(Reading.faces(file.mesh())).containsExactly("0,0,0 1,0,0 0,1,0");
        assertThat(file.notes())
                .containsExactly(
                        "Vertex properties skipped: junk, confidence.",
                        "Properties of face skipped: flags.",
                        "Elements skipped: camera.");
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
        String[] lines = square("3 0 1 2");
        lines[12] = "0 0 0";
        assertThat(Reading.read("a.ply", lines).mesh().vertices()).isEqualTo(4);
    }

    @ParameterizedTest
    @ValueSource(strings = {"s t", "u v", "texture_u texture_v"})
    void shouldKnowEveryNameOfTextureCoordinates(String names) throws IOException {
        String[] lines = square("3 0 1 2");
        lines[5] =
                "property float z\nproperty float " + names.split(" ")[0] + "\nproperty float " + names.split(" ")[1];
        for (int i = 9; i < 13; i++) lines[i] += " 0.25 0.5";
        Mesh mesh = Reading.read("a.ply", lines).mesh();
        assertThat(Reading.at(mesh, Channel.Semantic.TEXCOORD, 0, 2)).containsExactly(.25f, .5f);
    }

    @Test
    void shouldReadColoursOfFloatsWithAlpha() throws IOException {
        String[] lines = square("3 0 1 2");
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
        assertThat(file.mesh().materials().get(0).displayTexture()).isEqualTo("my wood.png");
        assertThat(file.mesh().textures().get(0).bytes()).asString().isEqualTo("PNG");
    }

    @Test
    void shouldReportDoublesThatRoundingChanges() throws IOException {
        String[] lines = square("3 0 1 2");
        lines[3] = "property double x";
        lines[10] = "0.1 0 0";
        ModelFile file = Reading.read("a.ply", lines);
        assertThat(file.mesh().positions()[3]).isEqualTo(.1f);
        assertThat(file.notes()).containsExactly("1 position value rounded to float32.");
    }

    @Test
    void shouldRoundDecimalTextOfFloatsWithoutANote() throws IOException {
        String[] lines = square("3 0 1 2");
        lines[10] = "0.1 -0 1e-45";
        ModelFile file = Reading.read("a.ply", lines);
        assertThat(file.mesh().positions()).contains(.1f, -0f, Float.MIN_VALUE);
        assertThat(Float.floatToRawIntBits(file.mesh().positions()[4])).isEqualTo(0x80000000);
        assertThat(file.notes()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"nan", "-NaN", "inf", "-Infinity", "1e39", "-nan(ind)", "1.#QNAN"})
    void shouldRefuseNumbersThatAreNotFiniteByNameAndLine(String number) {
        String[] lines = square("3 0 1 2");
        lines[10] = "0 " + number + " 0";
        ModelFormatException refusal = Reading.refusal("a.ply", lines);
        assertThat(refusal).hasMessageStartingWith("a.ply, line 11: y of vertex 1 is");
        assertThat(refusal.remedy()).isNotEmpty();
    }

    @Test
    void shouldNameTheByteOfANumberThatIsNotFinite() throws IOException {
        byte[] content = binary("float", ByteOrder.LITTLE_ENDIAN, 4);
        int data = content.length - 14 - 36;
        ByteBuffer.wrap(content).order(ByteOrder.LITTLE_ENDIAN).putFloat(data + 16, Float.NaN);
        assertThat(Reading.refusal("a.ply", content))
                .hasMessageStartingWith("a.ply, byte " + (data + 20) + ": y of vertex 1 is NaN");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "3 0 1 4|line 14|names vertex 4 of 4",
                "3 0 1 -1|line 14|names vertex -1 of 4",
                "3 0 1 0.5|line 14|no value of type int",
                "3 0 1|line 15|ends within its data",
                "200 0 1|line 14|has the length 200",
                "-1 0 1|line 14|no value of type uchar",
                "3 0 1 x|line 14|not a number"
            })
    void shouldRefuseBadFaces(String line, String place, String reason) {
        ModelFormatException refusal = Reading.refusal("a.ply", square(line));
        assertThat(refusal.place()).isEqualTo(place);
        assertThat(refusal.reason()).contains(reason);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "element vertex 4|element vertex 2000000000|needs at least",
                "element vertex 4|element vertex -4|has the number -4",
                "element vertex 4|element vertex 99999999999|not a whole number",
                "element vertex 4|element point 4|no element \"vertex\"",
                "property float x|property float w|has no x, y and z",
                "property float x|property float y|appears twice",
                "property float x|property quad x|unknown type",
                "property list uchar int vertex_indices|property list float int vertex_indices|list length of type",
                "property list uchar int vertex_indices|property list uchar int corners|no list vertex_indices",
                "format ascii 1.0|format morse 1.0|unknown format",
                "format ascii 1.0|comment|names no format",
                "end_header|comment|no end_header",
                "element face 1|what is this|unknown header line"
            })
    void shouldRefuseBadHeaders(String line, String replacement, String reason) {
        String[] lines = square("3 0 1 2");
        for (int i = 0; i < lines.length; i++) {
            if (lines[i].equals(line)) lines[i] = replacement;
        }
        if (reason.contains("end_header")) lines = java.util.Arrays.copyOf(lines, 9);
        assertThat(Reading.refusal("a.ply", lines).reason()).contains(reason);
    }

    @Test
    void shouldRefuseEveryTruncationOfABinaryFile() throws IOException {
        byte[] content = binary("double", ByteOrder.BIG_ENDIAN, 8);
        for (int length = 0; length < content.length; length++) {
            assertThat(Reading.refusal("a.ply", java.util.Arrays.copyOf(content, length)))
                    .as("%d bytes", length)
                    .isNotNull();
        }
    }

    @Test
    void shouldTakeDataBehindACarriageReturnAlone() throws IOException {
        byte[] lf = binary("float", ByteOrder.LITTLE_ENDIAN, 4);
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
