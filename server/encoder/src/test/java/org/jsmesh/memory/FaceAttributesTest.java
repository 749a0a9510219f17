package org.jsmesh.memory;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.function.IntUnaryOperator;
import org.assertj.core.data.Offset;
import org.jsmesh.encode.EncoderSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Where faces have attributes of their own, every corner is kept apart: three a face in place of half of one. */
class FaceAttributesTest {
    private static final int SIDE = 150;
    private static final int FACES = 2 * (SIDE - 1) * (SIDE - 1);

    /** Bytes by which three values at each corner are more than none. */
    private static final long VALUES_OF_CORNERS = 3 * 40 * 3L * FACES;

    @ParameterizedTest
    @CsvSource({"'',32768", "COLOR=xxxx,0"})
    void shouldSeeTheColoursOfAnStlFile(String header, int mark) throws IOException {
        MemoryEstimate plain = stl(header, i -> mark);
        assertThat(plain.channels()).isZero();
        MemoryEstimate colourful = stl(header, i -> i % 2000 | mark);
        assertThat(colourful.channels()).isEqualTo(3);
        assertThat(colourful.bytes() - plain.bytes()).isEqualTo(VALUES_OF_CORNERS);
        MemoryEstimate later = stl(header, i -> i < 5000 ? 1 | mark : i % 2000 | mark);
        assertThat(later.bytes()).isEqualTo(colourful.bytes());
    }

    @Test
    void shouldTellColoursOfPartsAndOtherWordsFromThose() throws IOException {
        long plain = stl("", i -> 0).bytes();
        assertThat(stl("", i -> i % 5 | 32768).bytes() - plain).isEqualTo(60L * FACES);
        assertThat(stl("", i -> i % 2000).bytes()).isEqualTo(plain);
        assertThat(stl("COLOR=xxxx", i -> i % 2000 | 32768).bytes()).isEqualTo(plain);
    }

    @ParameterizedTest
    @ValueSource(strings = {"red", "diffuse_red", "r"})
    void shouldSeeTheColoursOfFacesInAPlyFile(String red) throws IOException {
        long plain = ply("", 13).bytes();
        String colour = "property uchar " + red + "\nproperty uchar green\nproperty uchar blue\n";
        MemoryEstimate colourful = ply(colour, 16);
        assertThat(colourful.faces()).isEqualTo(FACES);
        assertThat(colourful.bytes() - plain).isEqualTo(VALUES_OF_CORNERS);
    }

    @Test
    void shouldNotTakeCoordinatesOfCornersForCorners() throws IOException {
        MemoryEstimate textured = ply("property list uchar float texcoord\n", 13 + 25);
        assertThat(textured.faces()).isEqualTo(FACES);
        assertThat(textured.channels()).isEqualTo(2);
        assertThat(textured.bytes()).isGreaterThan(ply("", 13).bytes() + 2 * 40 * 2L * FACES);
    }

    @Test
    void shouldSeeThatAnObjFileIsShadedFlat() throws IOException {
        MemoryEstimate flat = obj(FACES, k -> k + 1);
        assertThat(flat.channels()).isEqualTo(3);
        double smooth = obj(SIDE * SIDE, k -> 0).bytes();
        assertThat(flat.bytes() - smooth).isBetween(.8 * VALUES_OF_CORNERS * 5 / 6, 1.1 * VALUES_OF_CORNERS * 5 / 6);
        MemoryEstimate few = obj(6, k -> k % 6 + 1);
        assertThat((double) few.bytes())
                .as("six normals for all")
                .isCloseTo(flat.bytes(), Offset.offset(.1 * flat.bytes()));
    }

    @ParameterizedTest
    @ValueSource(ints = {3, 1})
    void shouldSeeTheColoursOfFacesInAnOffFile(int different) throws IOException {
        StringBuilder text = new StringBuilder("OFF\n" + SIDE * SIDE + " " + FACES + " 0\n").append(vertices(""));
        int[] k = {0};
        eachFace((a, b, c) -> {
            int grey = different == 1 ? 7 : k[0]++ % 250;
            text.append("3 ").append(a).append(' ').append(b).append(' ').append(c);
            text.append(' ').append(grey).append(" 20 30\n");
        });
        MemoryEstimate found = of("a.off", text);
        assertThat(found.faces()).isEqualTo(FACES);
        assertThat(found.channels()).isEqualTo(different == 1 ? 0 : 4);
        assertThat(found.bytes()).isGreaterThan(different == 1 ? 0 : 3 * 40 * 4L * FACES);
    }

    private interface Face {
        void take(int a, int b, int c);
    }

    private static void eachFace(Face face) {
        for (int v = 0; v < SIDE * (SIDE - 1); v++) {
            if (v % SIDE == SIDE - 1) continue;
            face.take(v, v + 1, v + SIDE);
            face.take(v + 1, v + SIDE + 1, v + SIDE);
        }
    }

    private static String vertices(String word) {
        StringBuilder text = new StringBuilder();
        for (int v = 0; v < SIDE * SIDE; v++)
            text.append(
                    String.format(Locale.ROOT, "%s%.5f %.5f %.5f%n", word, v % SIDE * .1, v / SIDE * .1, v % 7 * .01));
        return text.toString();
    }

    private static MemoryEstimate stl(String header, IntUnaryOperator word) throws IOException {
        ByteBuffer stl = ByteBuffer.allocate(84 + 50 * FACES).order(ByteOrder.LITTLE_ENDIAN);
        stl.put(header.getBytes(StandardCharsets.US_ASCII)).position(80).putInt(FACES);
        int[] i = {0};
        eachFace((a, b, c) -> {
            stl.position(stl.position() + 12);
            for (int v : new int[] {a, b, c})
                stl.putFloat(v % SIDE).putFloat(v / SIDE).putFloat(0);
            stl.putShort((short) word.applyAsInt(i[0]++));
        });
        return of("a.stl", stl.array());
    }

    private static MemoryEstimate ply(String properties, int faceBytes) throws IOException {
        String header = "ply\nformat binary_little_endian 1.0\nelement vertex " + SIDE * SIDE
                + "\nproperty float x\nproperty float y\nproperty float z\nelement face " + FACES
                + "\nproperty list uchar int vertex_indices\n" + properties + "end_header\n";
        byte[] start = header.getBytes(StandardCharsets.US_ASCII);
        long length = start.length + 12L * SIDE * SIDE + (long) faceBytes * FACES;
        return MemoryEstimate.of("a.ply", length, start, EncoderSettings.defaults());
    }

    /** @param normal of a face, from 1, or 0 where each vertex has one */
    private static MemoryEstimate obj(int normals, IntUnaryOperator normal) throws IOException {
        StringBuilder text = new StringBuilder(vertices("v ")).append("vn 0.1234 0.2345 0.3456\n".repeat(normals));
        int[] k = {0};
        eachFace((a, b, c) -> {
            int n = normal.applyAsInt(k[0]++);
            text.append('f');
            for (int v : new int[] {a, b, c})
                text.append(' ').append(v + 1).append("//").append(n == 0 ? v + 1 : n);
            text.append('\n');
        });
        return of("a.obj", text);
    }

    private static MemoryEstimate of(String name, StringBuilder text) throws IOException {
        return of(name, text.toString().getBytes(StandardCharsets.US_ASCII));
    }

    private static MemoryEstimate of(String name, byte[] all) throws IOException {
        return MemoryEstimate.of(name, all.length, ByteRanges.ofStart(all), EncoderSettings.defaults());
    }
}
