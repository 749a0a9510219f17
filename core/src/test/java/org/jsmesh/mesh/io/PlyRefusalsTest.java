package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What {@link PlyReader} refuses, with place, reason and remedy. */
class PlyRefusalsTest {
    @ParameterizedTest
    @ValueSource(strings = {"nan", "-NaN", "inf", "-Infinity", "1e39", "-nan(ind)", "1.#QNAN"})
    void shouldRefuseNumbersThatAreNotFiniteByNameAndLine(String number) {
        String[] lines = PlySamples.square("3 0 1 2");
        lines[10] = "0 " + number + " 0";
        ModelFormatException refusal = Reading.refusal("a.ply", lines);
        assertThat(refusal).hasMessageStartingWith("a.ply, line 11: y of vertex 1 is");
        assertThat(refusal.remedy()).isNotEmpty();
    }

    @Test
    void shouldNameTheByteOfANumberThatIsNotFinite() throws IOException {
        byte[] content = PlySamples.binary("float", ByteOrder.LITTLE_ENDIAN, 4);
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
        ModelFormatException refusal = Reading.refusal("a.ply", PlySamples.square(line));
        assertThat(refusal.place()).isEqualTo(place);
        assertThat(refusal.reason()).contains(reason);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "element vertex 4|element vertex 2000000000|needs at least",
                "element vertex 4|element vertex -4|has the number -4",
                "element vertex 4|element vertex 99999999999|more than fit into memory",
                "element vertex 4|element point 4|no element \"vertex\"",
                "property float x|property float w|has no x, y and z",
                "property float x|property float y|has no x, y and z",
                "element face 1|element vertex 1|appears twice",
                "property float x|property quad x|unknown type",
                "property list uchar int vertex_indices|property list float int vertex_indices|list length of type",
                "property list uchar int vertex_indices|property list uchar int corners|no list vertex_indices",
                "format ascii 1.0|format morse 1.0|unknown format",
                "format ascii 1.0|comment|names no format",
                "end_header|comment|no end_header"
            })
    void shouldRefuseBadHeaders(String line, String replacement, String reason) {
        String[] lines = PlySamples.square("3 0 1 2");
        for (int i = 0; i < lines.length; i++) {
            if (lines[i].equals(line)) lines[i] = replacement;
        }
        if (reason.contains("end_header")) lines = java.util.Arrays.copyOf(lines, 9);
        assertThat(Reading.refusal("a.ply", lines).reason()).contains(reason);
    }

    @Test
    void shouldRefuseEveryTruncationOfABinaryFile() throws IOException {
        byte[] content = PlySamples.binary("double", ByteOrder.BIG_ENDIAN, 8);
        for (int length = 0; length < content.length; length++) {
            assertThat(Reading.refusal("a.ply", java.util.Arrays.copyOf(content, length)))
                    .as("%d bytes", length)
                    .isNotNull();
        }
    }
}
