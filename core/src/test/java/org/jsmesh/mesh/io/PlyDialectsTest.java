package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.mesh.Note;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** PLY files that are not written quite as the format says. */
class PlyDialectsTest {
    private static final String HEADER = "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
            + "property float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\n";
    private static final String FACE = "0,0,0 1,0,0 0,1,0";

    /** @param end the bytes behind the word end_header */
    private static byte[] triangle(String header, String end, float firstX) {
        ByteBuffer data = ByteBuffer.allocate(36 + 13).order(ByteOrder.LITTLE_ENDIAN);
        for (float value : new float[] {firstX, 0, 0, 1, 0, 0, 0, 1, 0}) data.putFloat(value);
        data.put((byte) 3).putInt(0).putInt(1).putInt(2);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes((header + "end_header" + end).getBytes(StandardCharsets.ISO_8859_1));
        out.writeBytes(data.array());
        return out.toByteArray();
    }

    private static ModelFile read(byte[] content) throws IOException {
        return ModelReader.read("a.ply", content, ResourceResolver.NONE);
    }

    @ParameterizedTest
    @CsvSource({"N,N", "N,RN", "N,R", "RN,RN", "RN,N", "RN,R", "R,R", "R,N", "R,RN", "N,' N'", "N,' RN'"})
    void shouldFindTheDataBehindEveryLineEnd(String lines, String last) throws IOException {
        String end = last.replace('R', '\r').replace('N', '\n');
        String header = HEADER.replace("\n", lines.replace('R', '\r').replace('N', '\n'));
        ModelFile file = read(triangle(header, end, 0));
        assertThat(Reading.faces(file.mesh())).containsExactly(FACE);
        assertThat(file.notes()).isEmpty();
    }

    /** 10 is the byte LF: the first coordinate begins with what may be the end of the line. */
    @ParameterizedTest
    @ValueSource(strings = {"\r", "\n", "\r\n"})
    void shouldTakeALineFeedThatIsDataAsData(String end) throws IOException {
        float x = Float.intBitsToFloat(10);
        ModelFile file = read(triangle(HEADER.replace("\n", end.equals("\r") ? "\r" : "\n"), end, x));
        assertThat(file.mesh().positions()[0]).isEqualTo(x);
        assertThat(file.notes()).isEmpty();
    }

    @Test
    void shouldTellOfBytesBehindTheLastElement() throws IOException {
        byte[] content = triangle(HEADER, "\n", 0);
        ModelFile file = read(Arrays.copyOf(content, content.length + 5));
        assertThat(Reading.faces(file.mesh())).containsExactly(FACE);
        assertThat(file.notes())
                .containsExactly(Note.unread("5 bytes behind the last element skipped.", 5, "byte " + content.length));
    }

    @Test
    void shouldTellOfRowsBehindTheLastElement() throws IOException {
        ModelFile file = Reading.read("a.ply", PlySamples.square("3 0 1 2", "3 0 2 3", "", "3 1 2 3", ""));
        assertThat(Reading.faces(file.mesh())).containsExactly("0,0,0 1,0,0 1,1,0");
        assertThat(file.notes()).containsExactly(Note.unread("2 rows behind the last element skipped.", 2, "line 15"));
    }

    @Test
    void shouldSkipHeaderLinesOfNoKnownKind() throws IOException {
        String[] lines = PlySamples.square("3 0 1 2");
        lines[1] += "\nCreated by Blender3D 247 - www.blender.org\nobj_info num_cols 3";
        ModelFile file = Reading.read("a.ply", lines);
        assertThat(Reading.faces(file.mesh())).containsExactly("0,0,0 1,0,0 1,1,0");
        assertThat(file.notes())
                .containsExactly(Note.unread("1 header line of no known kind skipped: Created.", 1, "Created"));
    }

    @Test
    void shouldTakeTheFirstOfRepeatedProperties() throws IOException {
        String[] lines = PlySamples.square("3 0 1 2 9");
        lines[5] += "\nproperty float z";
        lines[7] += "\nproperty uchar vertex_indices";
        for (int i = 9; i < 13; i++) lines[i] += " 7";
        ModelFile file = Reading.read("a.ply", lines);
        assertThat(Reading.faces(file.mesh())).containsExactly("0,0,0 1,0,0 1,1,0");
        assertThat(file.notes()).extracting(Note::example).containsExactly("z", "vertex_indices");
    }

    @ParameterizedTest
    @ValueSource(strings = {"int64", "uint64", "long", "ulong"})
    void shouldReadIntegersOf64Bits(String type) throws IOException {
        for (ByteOrder order : List.of(ByteOrder.LITTLE_ENDIAN, ByteOrder.BIG_ENDIAN)) {
            String header = "ply\nformat binary_" + (order == ByteOrder.LITTLE_ENDIAN ? "little" : "big")
                    + "_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty "
                    + type + " id\nelement face 1\nproperty list uchar " + type + " vertex_indices\nend_header\n";
            ByteBuffer data = ByteBuffer.allocate(3 * 20 + 1 + 24).order(order);
            for (int v = 0; v < 3; v++)
                data.putFloat(v == 1 ? 1 : 0)
                        .putFloat(v == 2 ? 1 : 0)
                        .putFloat(0)
                        .putLong(-1);
            data.put((byte) 3).putLong(0).putLong(1).putLong(2);
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            out.writeBytes(header.getBytes(StandardCharsets.US_ASCII));
            out.writeBytes(data.array());
            assertThat(Reading.faces(read(out.toByteArray()).mesh())).containsExactly(FACE);
        }
    }

    @Test
    void shouldReadTextOf64BitIntegers() throws IOException {
        String[] lines = PlySamples.square("3 0 1 2");
        lines[5] += "\nproperty uint64 id";
        for (int i = 9; i < 13; i++) lines[i] += " 18446744073709551615";
        assertThat(Reading.faces(Reading.read("a.ply", lines).mesh())).containsExactly("0,0,0 1,0,0 1,1,0");
        for (int i = 9; i < 13; i++) lines[i] = lines[i].replace("18446744073709551615", "-1");
        assertThat(Reading.refusal("a.ply", lines).reason()).isEqualTo("\"-1\" is no value of type ulong");
    }

    @Test
    void shouldReadThisAsTheNameOfTheFile() throws IOException {
        String[] lines = PlySamples.square("3 0 1 2");
        lines[1] += "\ncomment TextureFile <this>_A.png";
        MemoryFiles files = new MemoryFiles().with("scan_A.png", "PNG");
        ModelFile file = ModelReader.read("scan.ply", Reading.bytes(lines), files);
        assertThat(file.notes()).isEmpty();
        assertThat(file.mesh().textures().get(0).path()).isEqualTo("scan_A.png");
        MemoryFiles written = new MemoryFiles();
        assertThat(ModelWriter.write(file.mesh(), ModelFormat.PLY, "out.ply", written))
                .isEmpty();
        assertThat(written.text("out.ply")).contains("\ncomment TextureFile scan_A.png\n");
        assertThat(written.text("scan_A.png")).isEqualTo("PNG");
    }
}
