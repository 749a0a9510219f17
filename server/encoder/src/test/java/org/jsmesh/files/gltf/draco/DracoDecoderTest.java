package org.jsmesh.files.gltf.draco;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.offset;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HexFormat;
import java.util.List;
import org.jsmesh.files.gltf.packed.PackedException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Decodes what Draco's own encoder made of a ring, by {@code make.mjs} in the resources. */
class DracoDecoderTest {
    private static final int POSITION = 0;
    private static final int NORMAL = 1;
    private static final int TEXTURE = 2;
    private static final int COLOR = 3;
    private static final int JOINTS = 4;
    private static final int WEIGHTS = 5;
    private static final int ALL_NUMBERS = 17;

    /** What was encoded. */
    record Ring(int across, int around, boolean holes, int numbers) {
        Ring(boolean holes) {
            this(8, 6, holes, ALL_NUMBERS);
        }

        List<String> triangles() {
            List<String> triangles = new ArrayList<>();
            for (int i = 0; i < across; i++) {
                for (int j = 0; j < around; j++) {
                    if (holes && (7 * i + 5 * j) % 11 == 0) continue;
                    triangles.add(turned(corner(i, j), corner(i + 1, j), corner(i, j + 1)));
                    triangles.add(turned(corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)));
                }
            }
            Collections.sort(triangles);
            return triangles;
        }

        private String corner(int i, int j) {
            int a = i % across;
            int b = j % around;
            double[] all = {
                2047 * a / (across - 1),
                29 * b + 7 * a,
                3 * a * b,
                2047 * i / across,
                2047 * j / around,
                20 * a,
                28 * b,
                200,
                255,
                a,
                300 * b,
                0,
                65535 - a,
                a / 16.0,
                b / 16.0,
                0.25,
                0
            };
            StringBuilder text = new StringBuilder();
            for (int n = 0; n < numbers; n++) text.append(all[n]).append(' ');
            return text.toString();
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "edgebreaker-0",
                "edgebreaker-5",
                "edgebreaker-10",
                "holes-0",
                "holes-7",
                "floats-0",
                "sequential-0",
                "sequential-10"
            })
    void shouldGiveTheTrianglesThatWereEncoded(String name) throws IOException, PackedException {
        DracoMesh mesh = decode(file(name));
        boolean holes = !name.startsWith("edgebreaker") && !name.equals("sequential-10");
        assertThat(triangles(mesh)).isEqualTo(new Ring(holes).triangles());
        // 9 x 7 corners, of which those at seams share positions. A hole takes the only quad of the first one.
        assertThat(mesh.points()).isEqualTo(holes ? 62 : 63);
        assertKind(mesh.attribute(POSITION), 3, 5126);
        assertKind(mesh.attribute(NORMAL), 3, 5126);
        assertKind(mesh.attribute(TEXTURE), 2, 5126);
        assertKind(mesh.attribute(COLOR), 4, 5121);
        assertKind(mesh.attribute(JOINTS), 4, 5123);
        assertKind(mesh.attribute(WEIGHTS), 4, 5126);
        assertThat(mesh.attribute(6)).isNull();
        for (int p = 0; p < mesh.points(); p++) assertNormal(mesh, p, name.matches("floats-0|sequential-10"));
    }

    @ParameterizedTest
    @CsvSource({"positions-0, true, 8, 6", "positions-7, false, 8, 6", "positions-valence, true, 26, 22"})
    void shouldGiveThePositionsThatWereEncodedAlone(String name, boolean holes, int across, int around)
            throws IOException, PackedException {
        DracoMesh mesh = decode(file(name));
        assertThat(mesh.attributes()).hasSize(1);
        assertThat(mesh.points()).isEqualTo(across * around);
        List<String> triangles = triangles(mesh, POSITION);
        assertThat(triangles).isEqualTo(new Ring(across, around, holes, 3).triangles());
    }

    private static void assertKind(DracoAttribute attribute, int components, int componentType) {
        assertThat(attribute.components()).isEqualTo(components);
        assertThat(attribute.componentType()).isEqualTo(componentType);
        assertThat(attribute.normalized()).isFalse();
    }

    /** The joints tell which vertex it is; ten bits of a coordinate of the square are about a 500th. */
    private static void assertNormal(DracoMesh mesh, int point, boolean exact) {
        int a = (int) number(mesh.attribute(JOINTS), point, 0);
        int b = (int) number(mesh.attribute(JOINTS), point, 1) / 300;
        double[] normal = {a - 3.5, b - 2, 3};
        double length = Math.sqrt(normal[0] * normal[0] + normal[1] * normal[1] + 9);
        for (int c = 0; c < 3; c++) {
            assertThat(number(mesh.attribute(NORMAL), point, c))
                    .isEqualTo(normal[c] / length, offset(exact ? 1e-7 : 0.003));
        }
    }

    /** In any order; each one begins with its lowest corner. */
    private static List<String> triangles(DracoMesh mesh) {
        return triangles(mesh, POSITION, TEXTURE, COLOR, JOINTS, WEIGHTS);
    }

    private static List<String> triangles(DracoMesh mesh, int... ids) {
        List<String> triangles = new ArrayList<>();
        for (int i = 0; i < mesh.indices().length; i += 3) {
            String a = corner(mesh, mesh.indices()[i], ids);
            String b = corner(mesh, mesh.indices()[i + 1], ids);
            String c = corner(mesh, mesh.indices()[i + 2], ids);
            triangles.add(turned(a, b, c));
        }
        Collections.sort(triangles);
        return triangles;
    }

    private static String corner(DracoMesh mesh, int point, int... ids) {
        StringBuilder text = new StringBuilder();
        for (int id : ids) {
            DracoAttribute attribute = mesh.attribute(id);
            for (int c = 0; c < attribute.components(); c++)
                text.append(number(attribute, point, c)).append(' ');
        }
        return text.toString();
    }

    private static double number(DracoAttribute attribute, int point, int component) {
        ByteBuffer values = ByteBuffer.wrap(attribute.values()).order(ByteOrder.LITTLE_ENDIAN);
        int i = point * attribute.components() + component;
        return switch (attribute.componentType()) {
            case 5121 -> Byte.toUnsignedInt(values.get(i));
            case 5123 -> Short.toUnsignedInt(values.getShort(2 * i));
            case 5126 -> values.getFloat(4 * i);
            default -> throw new IllegalArgumentException("" + attribute.componentType());
        };
    }

    private static String turned(String a, String b, String c) {
        return Collections.min(List.of(a + b + c, b + c + a, c + a + b));
    }

    @ParameterizedTest
    @ValueSource(strings = {"edgebreaker-0", "edgebreaker-5", "holes-7", "floats-0", "sequential-0", "sequential-10"})
    void shouldRefuseDataThatIsCutOff(String name) throws IOException {
        byte[] file = file(name);
        for (int length = 0; length < file.length; length++) {
            byte[] cut = Arrays.copyOf(file, length);
            assertThatThrownBy(() -> decode(cut)).isInstanceOf(PackedException.class);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"edgebreaker-0", "edgebreaker-10", "holes-7", "sequential-0"})
    void shouldThrowNothingElseWhenAByteIsWrong(String name) throws IOException {
        byte[] file = file(name);
        int refused = 0;
        for (int at = 0; at < file.length; at++) {
            for (int change : new int[] {0x01, 0x80, 0xFF}) {
                byte[] changed = file.clone();
                changed[at] ^= (byte) change;
                try {
                    DracoMesh mesh = decode(changed);
                    for (int index : mesh.indices()) assertThat(index).isBetween(0, mesh.points() - 1);
                } catch (PackedException e) {
                    assertThat(e.reason()).isNotBlank();
                    refused++;
                }
            }
        }
        assertThat(refused).isBetween(file.length / 4, 3 * file.length);
    }

    @ParameterizedTest
    @ValueSource(strings = {"edgebreaker-0", "holes-0", "sequential-0"})
    void shouldRefuseAMeshThatIsLargerThanAllowed(String name) throws IOException, PackedException {
        ByteBuffer file = ByteBuffer.wrap(file(name));
        DracoMesh mesh = decode(file.array());
        int faces = mesh.indices().length / 3;
        assertThat(DracoDecoder.decode(file, mesh.points(), faces).points()).isEqualTo(mesh.points());
        assertThat(file.position()).isZero();
        assertThatThrownBy(() -> DracoDecoder.decode(file, mesh.points() - 1, faces))
                .isInstanceOf(PackedException.class)
                .hasMessage("the Draco data has " + mesh.points() + " points, which is too many");
        assertThatThrownBy(() -> DracoDecoder.decode(file, mesh.points(), faces - 1))
                .isInstanceOf(PackedException.class)
                .hasMessage("the Draco data has " + faces + " faces, which is too many");
    }

    @ParameterizedTest
    @CsvSource({
        "445241434e 0202 01 01 0000, this is no Draco data",
        "445241434f 0201 01 01 0000, the Draco data has version 2.1 and not 2.2",
        "445241434f 0202 00 01 0000, the Draco data is not a mesh of triangles",
        "445241434f 0202 01 02 0000, the Draco method 2 is not known",
        // 2^31 - 1 and 2^28 faces and points in a few bytes
        "445241434f 0202 01 00 0000 ffffffff07 ffffffff07 01, 'has 2147483647 faces, which is too many'",
        "445241434f 0202 01 00 0000 ffffffff0f 01 01, a count of the packed data is out of range",
        "445241434f 0202 01 00 0000 ffff0f 80808001 00, the Draco data is too short for its faces",
        "445241434f 0202 01 01 0000 00 8080808001 8080808001 00 00 00, 'has 268435456 faces, which is too many'",
        "445241434f 0202 01 01 0000 00 04 03 00 04 00 00, the counts of the Draco mesh contradict each other",
        "445241434f 0202 01 01 0000 01 03 01 00 01 00 00 00 01 00 00, the edgebreaker method 1 is not known",
        // no faces, 2^28 points with an attribute of integers: type, components, id, method, prediction
        "445241434f 0202 01 00 0000 00 8080808001 01 01 01 00 02 04 00 00 01 fe 00 01, which is too many",
        // 2^28 symbols in the table of an entropy coder
        "445241434f 0202 01 00 0000 01 03 00 01 08 8080808001 00, the table of an entropy coder is damaged",
    })
    void shouldSayWhatIsWrong(String hexadecimal, String reason) {
        byte[] packed = HexFormat.of().parseHex(hexadecimal.replace(" ", ""));
        assertThatThrownBy(() -> DracoDecoder.decode(ByteBuffer.wrap(packed), Integer.MAX_VALUE, Integer.MAX_VALUE))
                .isInstanceOfSatisfying(
                        PackedException.class, e -> assertThat(e.reason()).contains(reason));
    }

    @Test
    void shouldStepOverMetadata() throws IOException, PackedException {
        byte[] file = file("edgebreaker-0");
        // Of one attribute: an entry and two children; of the mesh: nothing. Draco's own decoder reads it, too.
        byte[] metadata = HexFormat.of().parseHex("01000101610278790201630000016400000000");
        ByteArrayOutputStream with = new ByteArrayOutputStream();
        with.write(file, 0, 10);
        with.write(0x80);
        with.write(metadata);
        with.write(file, 11, file.length - 11);
        assertThat(triangles(decode(with.toByteArray()))).isEqualTo(new Ring(false).triangles());
    }

    private static DracoMesh decode(byte[] packed) throws PackedException {
        return DracoDecoder.decode(ByteBuffer.wrap(packed), 2000, 2000);
    }

    private static byte[] file(String name) throws IOException {
        String path = "DracoFuzzTestInputs/shouldThrowNothingButPackedException/" + name + ".drc";
        try (InputStream in = DracoDecoderTest.class.getResourceAsStream(path)) {
            return in.readAllBytes();
        }
    }
}
