package org.jsmesh.memory;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import org.assertj.core.data.Percentage;
import org.jsmesh.encode.EncoderSettings;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Models of text, whole or their beginning alone. */
class TextEstimateTest {
    private static final int SIDE = 121;
    private static final int QUADS = (SIDE - 1) * (SIDE - 1);
    private static final String MARK = "\ufeff";

    @ParameterizedTest
    @ValueSource(strings = {"\n", "\r\n", "\r"})
    void shouldReadLinesThatEndInAnyWay(String end) throws IOException {
        StringBuilder text = vertices("v ");
        for (int v = 0; v < SIDE * (SIDE - 1); v++)
            if (v % SIDE < SIDE - 1)
                text.append(String.format("f %d %d %d %d\n", v + 1, v + 2, v + SIDE + 2, v + SIDE + 1));
        assertThat(text.length()).isGreaterThan(Sampled.SAMPLES * 4096);
        for (String model : new String[] {text.toString(), MARK + text}) {
            byte[] all = model.replace("\n", end).getBytes(StandardCharsets.UTF_8);
            assertThat(whole("a.obj", all).faces()).isCloseTo(2 * QUADS, Percentage.withPercentage(5));
        }
        String small = text.substring(0, 50_000) + "f 1 2 3\n".repeat(5000);
        assertThat(whole("a.obj", small.replace("\n", end).getBytes(StandardCharsets.UTF_8))
                        .faces())
                .isEqualTo(5000);
    }

    @ParameterizedTest
    @CsvSource({"PLY,\\n", "PLY,\\r\\n", "PLY,\\r", "OFF,\\n", "OFF,\\r\\n", "OFF,\\r"})
    void shouldCountTheTrianglesOfPolygons(String format, String end) throws IOException {
        String header = format.equals("OFF")
                ? "OFF\n" + SIDE * SIDE + " " + QUADS + " 0\n"
                : "ply\nformat ascii 1.0\nelement vertex " + SIDE * SIDE + "\nproperty float x\nproperty float y\n"
                        + "property float z\nelement face " + QUADS
                        + "\nproperty uchar flags\nproperty list uchar int vertex_indices\nend_header\n";
        StringBuilder text = vertices("").insert(0, header);
        for (int v = 0; v < SIDE * (SIDE - 1); v++)
            if (v % SIDE < SIDE - 1)
                text.append(format.equals("OFF") ? "" : "9 ")
                        .append(String.format("4 %d %d %d %d\n", v, v + 1, v + SIDE + 1, v + SIDE));
        String ends = end.replace("\\n", "\n").replace("\\r", "\r");
        for (String model : new String[] {text.toString(), MARK + text}) {
            byte[] all = model.replace("\n", ends).getBytes(StandardCharsets.UTF_8);
            MemoryEstimate found = whole("a", all);
            assertThat(found.faces()).isEqualTo(2 * QUADS);
            assertThat(found.leastBytes())
                    .as("no more than a triangle each is sure")
                    .isBetween(1L, 140L * QUADS);
            byte[] start = java.util.Arrays.copyOf(all, MemoryEstimate.START_BYTES);
            MemoryEstimate begun = MemoryEstimate.of("a", all.length, start, EncoderSettings.defaults());
            assertThat(begun.faces()).isCloseTo(2 * QUADS, Percentage.withPercentage(20));
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void shouldCountTheFacetsOfWhichTheFirstAreKnown(boolean apart) throws IOException {
        StringBuilder text = new StringBuilder("solid a\n");
        int facets = 4000;
        for (int i = 0; i < facets; i++) {
            text.append("facet normal 0 0 1\nouter loop\n");
            for (int c = 0; c < 3; c++)
                text.append("vertex ").append(apart ? 3 * i + c : i + c).append(" 0.25 1.50\n");
            text.append("endloop\nendfacet\n");
        }
        byte[] all = text.append("endsolid a\n").toString().getBytes(StandardCharsets.US_ASCII);
        byte[] start = java.util.Arrays.copyOf(all, MemoryEstimate.START_BYTES);
        MemoryEstimate begun = MemoryEstimate.of("a.stl", all.length, start, EncoderSettings.defaults());
        assertThat(begun.faces()).isCloseTo(facets, Percentage.withPercentage(5));
        assertThat(begun.leastBytes()).isZero();
        MemoryEstimate found = whole("a.stl", all);
        assertThat(found.faces()).isCloseTo(facets, Percentage.withPercentage(1));
        long surface = (long) (18e6 + 260 * found.faces());
        if (apart) assertThat(found.bytes()).isGreaterThan(surface + 100L * facets);
        else assertThat(found.bytes()).isCloseTo(surface, Percentage.withPercentage(1));
    }

    private static StringBuilder vertices(String word) {
        StringBuilder text = new StringBuilder();
        for (int v = 0; v < SIDE * SIDE; v++)
            text.append(
                    String.format(Locale.ROOT, "%s%.6f %.6f %.6f\n", word, v % SIDE * .1, v / SIDE * .1, v % 7 * .01));
        return text;
    }

    private static MemoryEstimate whole(String name, byte[] all) throws IOException {
        return MemoryEstimate.of(name, all.length, ByteRanges.ofStart(all), EncoderSettings.defaults());
    }
}
