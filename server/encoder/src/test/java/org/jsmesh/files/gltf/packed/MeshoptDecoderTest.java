package org.jsmesh.files.gltf.packed;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Base64;
import java.util.HexFormat;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Decodes what meshoptimizer's encoder made: {@code packed.txt}, by {@code make.mjs} beside it. */
class MeshoptDecoderTest {
    private static final Set<String> INDICES = Set.of("TRIANGLES", "INDICES");

    /** A line of {@code packed.txt}. */
    record Line(
            String values, int level, int version, String mode, String filter, int count, int stride, byte[] packed) {
        static Line of(String text) {
            String[] parts = text.split(" ");
            return new Line(
                    parts[0],
                    Integer.parseInt(parts[1]),
                    Integer.parseInt(parts[2]),
                    parts[3],
                    parts[4],
                    Integer.parseInt(parts[5]),
                    Integer.parseInt(parts[6]),
                    Base64.getDecoder().decode(parts[7]));
        }

        byte[] decode(byte[] bytes) throws PackedException {
            return MeshoptDecoder.decode(ByteBuffer.wrap(bytes), count, stride, mode, filter);
        }

        @Override
        public String toString() {
            return values + " " + mode + " " + filter + " " + version + " " + level + " " + count + " x " + stride;
        }
    }

    static Stream<Line> lines() throws IOException {
        try (InputStream in = MeshoptDecoderTest.class.getResourceAsStream("packed.txt")) {
            return new String(in.readAllBytes(), StandardCharsets.US_ASCII)
                    .lines()
                    .map(Line::of);
        }
    }

    static Stream<Line> attributes() throws IOException {
        return lines().filter(line -> !INDICES.contains(line.mode) && line.filter.equals("NONE"));
    }

    static Stream<Line> filters() throws IOException {
        return lines().filter(line -> !line.filter.equals("NONE"));
    }

    static Stream<Line> indices() throws IOException {
        return lines().filter(line -> INDICES.contains(line.mode));
    }

    @ParameterizedTest
    @MethodSource("attributes")
    void shouldGiveTheAttributesThatWereEncoded(Line line) throws PackedException {
        ByteBuffer expected = ByteBuffer.allocate(line.count * line.stride).order(ByteOrder.LITTLE_ENDIAN);
        int[] state = {1};
        for (int i = 0; i < line.count; i++) {
            for (int k = 0; k < line.stride / 4; k++) expected.putInt(attribute(line.values, i, k, state));
        }
        assertThat(line.decode(line.packed)).isEqualTo(expected.array());
    }

    private static int attribute(String name, int i, int k, int[] state) {
        return switch (name) {
            case "bytes" -> (i * (k + 1) & 255) * 0x01010101;
            case "shorts" -> (i * i * 3 + 1000 * k & 0xFFFF) | (i * 7 & 0xFFFF) << 16;
            case "floats" -> Float.floatToIntBits(i * i * (k + 1) / 128f);
            case "noise" -> random(state) << 8;
            case "sparse" -> i % 13 == k ? i : 7;
            default -> throw new IllegalArgumentException(name);
        };
    }

    /** 24 bits. */
    private static int random(int[] state) {
        state[0] = state[0] * 1103515245 + 12345;
        return state[0] >>> 8;
    }

    @ParameterizedTest
    @MethodSource("filters")
    void shouldGiveWhatMeshoptimizerGivesAfterItsFilters(Line line) throws PackedException {
        assertThat(line.decode(line.packed)).isEqualTo(Base64.getDecoder().decode(line.values));
    }

    @ParameterizedTest
    @MethodSource("indices")
    void shouldGiveTheIndicesThatWereEncoded(Line line) throws PackedException {
        ByteBuffer decoded = ByteBuffer.wrap(line.decode(line.packed)).order(ByteOrder.LITTLE_ENDIAN);
        int[] values = new int[line.count];
        for (int i = 0; i < values.length; i++) {
            values[i] = line.stride == 2 ? Short.toUnsignedInt(decoded.getShort()) : decoded.getInt();
        }
        int[] expected = indices(line.values);
        assertThat(decoded.hasRemaining()).isFalse();
        if (line.mode.equals("INDICES")) assertThat(values).containsExactly(expected);
        else assertThat(triangles(values)).isEqualTo(triangles(expected));
    }

    private static int[] indices(String name) {
        int[] state = {1};
        return switch (name) {
            case "grid" -> grid(8, 0);
            case "twice" -> joined(grid(4, 0), grid(4, 0));
            case "chaos" ->
                Stream.generate(() -> random(state) % 50)
                        .limit(60)
                        .mapToInt(i -> i)
                        .toArray();
            case "large" -> joined(grid(3, 65500 - 16), new int[] {7, 65000, 3});
            case "again" -> new int[] {0, 1, 2, 1, 3, 2, 0, 1, 2, 1, 3, 2};
            case "down" ->
                Stream.iterate(0, i -> i + 1)
                        .limit(60)
                        .mapToInt(i -> 90 - i / 3 - new int[] {0, 1, 2, 1, 0, 2}[i % 6])
                        .toArray();
            case "soup" ->
                Stream.iterate(0, i -> i + 1).limit(30).mapToInt(i -> i).toArray();
            default -> throw new IllegalArgumentException(name);
        };
    }

    private static int[] grid(int size, int from) {
        int[] corners = {0, 1, size + 1, 1, size + 2, size + 1};
        int[] indices = new int[6 * size * size];
        for (int n = 0; n < indices.length; n++) {
            indices[n] = from + n / 6 / size * (size + 1) + n / 6 % size + corners[n % 6];
        }
        return indices;
    }

    private static int[] joined(int[] first, int[] second) {
        int[] all = Arrays.copyOf(first, first.length + second.length);
        System.arraycopy(second, 0, all, first.length, second.length);
        return all;
    }

    /** The encoder turns triangles: they begin with their lowest index here. */
    private static String triangles(int[] indices) {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < indices.length; i += 3) {
            int a = indices[i];
            int b = indices[i + 1];
            int c = indices[i + 2];
            String first = String.format("%d %d %d", a, b, c);
            String second = String.format("%d %d %d", b, c, a);
            String third = String.format("%d %d %d", c, a, b);
            text.append(Stream.of(first, second, third).sorted().findFirst().orElseThrow())
                    .append('\n');
        }
        return text.toString();
    }

    @ParameterizedTest
    @MethodSource("lines")
    void shouldRefuseDataThatIsCutOffOrHasMore(Line line) {
        for (int length = 0; length < line.packed.length; length++) {
            byte[] cut = Arrays.copyOf(line.packed, length);
            assertThatThrownBy(() -> line.decode(cut)).isInstanceOf(PackedException.class);
        }
        byte[] longer = Arrays.copyOf(line.packed, line.packed.length + 1);
        assertThatThrownBy(() -> line.decode(longer)).isInstanceOf(PackedException.class);
    }

    @Test
    void shouldReadFromPositionToLimitAndLeaveThem() throws PackedException, IOException {
        Line line = lines().findFirst().orElseThrow();
        ByteBuffer larger = ByteBuffer.allocateDirect(line.packed.length + 7);
        larger.position(3).put(line.packed).flip().position(3);
        assertThat(MeshoptDecoder.decode(larger, line.count, line.stride, line.mode, null))
                .isEqualTo(line.decode(line.packed));
        assertThat(larger.position()).isEqualTo(3);
        assertThat(larger.limit()).isEqualTo(3 + line.packed.length);
    }

    @ParameterizedTest
    @CsvSource({
        "ATTRIBUTES, 1073741824, 4, NONE, elements of 4 bytes are too many",
        "ATTRIBUTES, 4194304, 256, NONE, too short for 4194304 elements",
        "ATTRIBUTES, -1, 4, NONE, are too many",
        "TRIANGLES, 268435455, 4, NONE, too short for 89478485 triangles",
        "INDICES, 268435456, 4, NONE, too short for 268435456 indices",
        "TRIANGLES, 4, 2, NONE, 4 indices are not whole triangles",
        "TRIANGLES, 3, 8, NONE, TRIANGLES has a stride of 8 bytes",
        "INDICES, 3, 2, OCTAHEDRAL, the mode INDICES has the filter OCTAHEDRAL",
        "ATTRIBUTES, 1, 6, NONE, ATTRIBUTES has a stride of 6 bytes",
        "ATTRIBUTES, 1, 260, NONE, ATTRIBUTES has a stride of 260 bytes",
        "ATTRIBUTES, 1, 12, OCTAHEDRAL, OCTAHEDRAL has a stride of 12 bytes",
        "ATTRIBUTES, 1, 4, QUATERNION, QUATERNION has a stride of 4 bytes",
        "ATTRIBUTES, 1, 12, COLOR, COLOR has a stride of 12 bytes",
        "ATTRIBUTES, 1, 4, SHARPEN, the compression filter SHARPEN is not known",
        "STRIPS, 1, 4, NONE, the compression mode STRIPS is not known",
    })
    void shouldSayWhatIsWrongBeforeAnythingIsAllocated(
            String mode, int count, int stride, String filter, String reason) {
        byte[] packed = new byte[300];
        packed[0] = (byte) (mode.equals("ATTRIBUTES") ? 0xA0 : mode.equals("TRIANGLES") ? 0xE1 : 0xD1);
        assertThatThrownBy(() -> MeshoptDecoder.decode(ByteBuffer.wrap(packed), count, stride, mode, filter))
                .isInstanceOfSatisfying(
                        PackedException.class, e -> assertThat(e.reason()).contains(reason));
    }

    @ParameterizedTest
    @CsvSource({
        // A triangle on an edge, and one with a vertex, before there are any.
        "TRIANGLES, e1 00 00000000000000000000000000000000, that is not there",
        "TRIANGLES, e1 f0 10000000000000000000000000000000, that is not there",
        "TRIANGLES, e1 f0 00000000000000000000000000000001, the table of triangle codes is damaged",
        "TRIANGLES, e1 f0 0f000000000000000000000000000000, the table of triangle codes is damaged",
        "TRIANGLES, e0 f0 00000000000000000000000000000000, begins with the byte 224",
        "TRIANGLES, e1 ff ffffffffffff7f000000 00000000000000000000000000000000, more than five bytes",
        "INDICES, d0 000000 00000000, begins with the byte 208",
        "INDICES, d1 8080808080800000 00000000, more than five bytes",
        "ATTRIBUTES, a2 0000000000000000000000000000000000000000000000000000, begins with the byte 162",
        // The last byte has the mode of the only channel.
        "ATTRIBUTES, a1 aa 00000000000000000000000000000000000000000000000003, the channel mode 3 is not known",
        "ATTRIBUTES, a1 aa 00000000000000000000000000000000000000000000000010, the channel mode 16 is not known",
    })
    void shouldRefuseCodesThatMeanNothing(String mode, String hexadecimal, String reason) {
        byte[] packed = HexFormat.of().parseHex(hexadecimal.replace(" ", ""));
        assertThatThrownBy(() -> MeshoptDecoder.decode(ByteBuffer.wrap(packed), 3, 4, mode, null))
                .isInstanceOfSatisfying(
                        PackedException.class, e -> assertThat(e.reason()).contains(reason));
    }
}
