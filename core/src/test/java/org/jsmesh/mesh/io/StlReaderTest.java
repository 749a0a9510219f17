package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class StlReaderTest {
    private static final String[] TEXT = {
        "solid my part", "facet normal 0 0 1", "outer loop", "vertex 0 0 0", "vertex 1 0 0", "vertex 0 1 0", "endloop",
                "endfacet",
        "FACET NORMAL nan nan nan", "OUTER LOOP", "VERTEX 0 1 0", "VERTEX 1 0 0", "VERTEX 1 1 -0", "ENDLOOP",
                "ENDFACET", "endsolid my part"
    };

    private static byte[] binary(String header, float... coordinates) {
        int facets = coordinates.length / 9;
        ByteBuffer data = ByteBuffer.allocate(84 + 50 * facets).order(ByteOrder.LITTLE_ENDIAN);
        data.put(header.getBytes(java.nio.charset.StandardCharsets.US_ASCII)).putInt(80, facets);
        for (int i = 0; i < coordinates.length; i++)
            data.putFloat(84 + 50 * (i / 9) + 12 + 4 * (i % 9), coordinates[i]);
        return data.array();
    }

    @Test
    void shouldReadTextAndWeld() throws IOException {
        Mesh mesh = Reading.read("a.stl", TEXT).mesh();
        assertThat(mesh.vertices()).isEqualTo(4);
        assertThat(Reading.faces(mesh)).containsExactly("0,0,0 1,0,0 0,1,0", "0,1,0 1,0,0 1,1,-0");
    }

    @Test
    void shouldReadBinaryFilesThatBeginWithSolid() throws IOException {
        byte[] content = binary("solid but binary", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0);
        ModelFile file = ModelReader.read("a.stl", content, ResourceResolver.NONE);
        assertThat(file.format()).isEqualTo(ModelFormat.STL);
        assertThat(file.mesh().vertices()).isEqualTo(4);
        assertThat(Reading.faces(file.mesh())).containsExactly("0,0,0 1,0,0 0,1,0", "0,1,0 1,0,0 1,1,0");
        assertThat(file.notes()).isEmpty();
    }

    @Test
    void shouldNotWeldZerosOfDifferentSign() throws IOException {
        byte[] content = binary("", 0, 0, 0, 1, 0, 0, 0, 1, 0, -0f, 0, 0, 0, 1, 0, 1, 0, 0);
        assertThat(ModelReader.read("a.stl", content, ResourceResolver.NONE)
                        .mesh()
                        .vertices())
                .isEqualTo(4);
    }

    @Test
    void shouldReportBytesBehind() throws IOException {
        byte[] content = Arrays.copyOf(binary("x", 0, 0, 0, 1, 0, 0, 0, 1, 0), 137);
        assertThat(ModelReader.read("a.stl", content, ResourceResolver.NONE).notes())
                .containsExactly(Note.unread("3 bytes behind the last facet skipped.", 3, "byte 134"));
    }

    @Test
    void shouldReadSeveralSolids() throws IOException {
        String[] twice = Arrays.copyOf(TEXT, 2 * TEXT.length);
        System.arraycopy(TEXT, 0, twice, TEXT.length, TEXT.length);
        ModelFile file = Reading.read("a.stl", twice);
        assertThat(file.mesh().faces()).isEqualTo(4);
        assertThat(file.notes()).containsExactly(Note.dropped("2 solids read as one mesh.", 2, "my part"));
    }

    @Test
    void shouldRefuseTruncatedBinaryFiles() {
        byte[] content = binary("x", 0, 0, 0, 1, 0, 0, 0, 1, 0);
        ModelFormatException refusal = Reading.refusal("a.stl", Arrays.copyOf(content, 120));
        assertThat(refusal)
                .hasMessage(
                        "a.stl, byte 80: 1 facets need 134 bytes but there are 120. The file is cut off; get it again.");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "0|REPAIRED|The header counts 0 facets, but the file holds 2: all are read.",
                "1|REPAIRED|The header counts 1 facet, but the file holds 2: all are read.",
                "3|DROPPED|The header counts 3 facets, but the file holds 2: the count is wrong, or the file is cut off.",
                "-1|DROPPED|The header counts 4294967295 facets, but the file holds 2: the count is wrong, or the file is cut off."
            })
    void shouldReadAsManyFacetsAsThereAreAndTellOfAWrongCount(int count, Note.Kind kind, String text)
            throws IOException {
        byte[] content = binary("exported", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0);
        ByteBuffer.wrap(content).order(ByteOrder.LITTLE_ENDIAN).putInt(80, count);
        ModelFile file = ModelReader.read("a.stl", content, ResourceResolver.NONE);
        assertThat(Reading.faces(file.mesh())).containsExactly("0,0,0 1,0,0 0,1,0", "0,1,0 1,0,0 1,1,0");
        assertThat(file.notes()).singleElement().satisfies(note -> {
            assertThat(note.kind()).isEqualTo(kind);
            assertThat(note.text()).isEqualTo(text);
        });
    }

    @Test
    void shouldReadFilesThatCountNothingAndEndWithMore() throws IOException {
        byte[] content = Arrays.copyOf(binary("exported", 0, 0, 0, 1, 0, 0, 0, 1, 0), 134 + 2);
        content[80] = 0;
        ModelFile file = ModelReader.read("a.stl", content, ResourceResolver.NONE);
        assertThat(Reading.faces(file.mesh())).containsExactly("0,0,0 1,0,0 0,1,0");
        assertThat(file.notes())
                .extracting(Note::text)
                .containsExactly(
                        "The header counts 0 facets, but the file holds 1: all are read.",
                        "2 bytes behind the last facet skipped.");
    }

    @Test
    void shouldNotTakeZerosForFacets() throws IOException {
        ModelFile file = ModelReader.read("a.stl", new byte[84 + 50 * 7], new MemoryFiles());
        assertThat(file.mesh().faces()).isZero();
    }

    @Test
    void shouldNotTakeBytesThatAreNoNumbersForFacets() throws IOException {
        byte[] content = Arrays.copyOf(binary("exported", 0, 0, 0, 1, 0, 0, 0, 1, 0), 184);
        Arrays.fill(content, 134, 184, (byte) 0xFF);
        ModelFile file = ModelReader.read("a.stl", content, ResourceResolver.NONE);
        assertThat(file.mesh().faces()).isEqualTo(1);
        assertThat(file.notes())
                .containsExactly(Note.unread("50 bytes behind the last facet skipped.", 50, "byte 134"));
    }

    @Test
    void shouldRefuseCountsThatTheLengthContradicts() {
        byte[] content = Arrays.copyOf(binary("x", 0, 0, 0, 1, 0, 0, 0, 1, 0), 140);
        Arrays.fill(content, 80, 84, (byte) 0xFF);
        assertThat(Reading.refusal("a.stl", content).reason()).startsWith("4294967295 facets need");
    }

    @Test
    void shouldNameTheByteOfACoordinateThatIsNotFinite() {
        byte[] content = binary("x", 0, 0, 0, 1, Float.POSITIVE_INFINITY, 0, 0, 1, 0);
        assertThat(Reading.refusal("a.stl", content))
                .hasMessageStartingWith("a.stl, byte 112: y of vertex 2 of facet 0 is Infinity");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "vertex 0 0 nan|z of vertex 1 is \"nan\"",
                "vertex 0 0|z of vertex 1 is missing",
                "vortex 0 0 0|\"vortex\" where a facet should be"
            })
    void shouldRefuseBadLines(String line, String reason) {
        String[] lines = TEXT.clone();
        lines[3] = line;
        ModelFormatException refusal = Reading.refusal("a.stl", lines);
        assertThat(refusal.place()).isEqualTo("line 4");
        assertThat(refusal.reason()).contains(reason);
    }

    @Test
    void shouldRefuseATextThatEndsWithinAFacet() {
        assertThat(Reading.refusal("a.stl", Arrays.copyOf(TEXT, 5)).reason()).isEqualTo("the file ends within a facet");
    }
}
