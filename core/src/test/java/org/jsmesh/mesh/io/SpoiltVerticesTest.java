package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Note;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Coordinates that are no finite numbers: they cost a vertex that no face uses, and the model where one does. */
class SpoiltVerticesTest {
    private static final String PLY = "ply/format ascii 1.0/element vertex 5/property float x/property float y/"
            + "property float z/property uchar q/element face 1/property list uchar int vertex_indices/end_header/"
            + "0 0 0 1/nan 0 inf 2/1 0 0 3/0 1 0 4/0 0 1e99 5/3 0 2 %d";
    private static final String OFF =
            "COFF/5 1 0/0 0 0 1 0 9/nan 0 inf 2 0 9/1 0 0 3 0 9/0 1 0 4 0 9/0 0 1e99 5 0 9/3 0 2 %d";
    private static final String HOPPE =
            "Vertex 0 0 0 0/Vertex 1 nan 0 inf/Vertex 2 1 0 0/Vertex 3 0 1 0/Vertex 4 0 0 1e99/Face 1 0 2 %d";

    private static String[] lines(String name, int corner) {
        String text = name.endsWith("ply") ? PLY : name.endsWith("off") ? OFF : HOPPE;
        return text.formatted(corner).split("/");
    }

    @ParameterizedTest
    @CsvSource({"a.ply,line 12", "a.off,line 4", "a.m,line 2"})
    void shouldLeaveOutThoseThatNoFaceUses(String name, String place) throws IOException {
        ModelFile file = Reading.read(name, lines(name, 3));
        assertThat(Reading.faces(file.mesh())).containsExactly("0,0,0 1,0,0 0,1,0");
        assertThat(file.mesh().vertices()).isEqualTo(3);
        assertThat(file.notes())
                .containsExactly(
                        Note.dropped("2 vertices that are not finite and that no face uses left out.", 2, place));
    }

    @Test
    void shouldKeepAttributesWithTheirVertices() throws IOException {
        Channel q = Reading.read("a.ply", lines("a.ply", 3)).mesh().channels().get(0);
        assertThat(q.values()).containsExactly(1, 3, 4);
        Channel colour =
                Reading.read("a.off", lines("a.off", 3)).mesh().channels().get(0);
        assertThat(colour.values()).containsExactly(1, 0, 9, 3, 0, 9, 4, 0, 9);
    }

    @ParameterizedTest
    @CsvSource({
        "a.ply,1,'a.ply, line 12: x of vertex 1 is NaN, not a finite float32'",
        "a.ply,4,'a.ply, line 15: z of vertex 4 is Infinity, not a finite float32'",
        "a.off,1,'a.off, line 4: x of vertex 1 is \"nan\", not a finite number'",
        "a.off,4,'a.off, line 7: z of vertex 4 is \"1e99\", beyond the range of float32. Scale the model down'",
        "a.m,1,'a.m, line 2: x of Vertex 1 is \"nan\", not a finite number'"
    })
    void shouldRefuseThoseThatAFaceUses(String name, int corner, String message) {
        assertThat(Reading.refusal(name, lines(name, corner))).hasMessageStartingWith(message);
    }

    @ParameterizedTest
    @CsvSource({
        "a.ply,ply/format ascii 1.0/element vertex 1/property float x/property float y/property float z/end_header/"
                + "0 nan 0,'a.ply, line 8: y of vertex 0 is NaN, not a finite float32'",
        "a.obj,v 0 0 infinity 0,'a.obj, line 1: z of vertex 1 is \"infinity\", not a finite number'",
        "a.off,OFF/2 0 0/nan 0 0/0 nan 0,'a.off, line 3: x of vertex 0 is \"nan\", not a finite number'",
        "a.m,Vertex 1 0 0 nan,'a.m, line 1: z of Vertex 1 is \"nan\", not a finite number'"
    })
    void shouldRefuseAFileOfNothingElse(String name, String text, String message) {
        assertThat(Reading.refusal(name, text.split("/"))).hasMessageStartingWith(message);
    }

    @Test
    void shouldNameTheByteOfABinaryFile() throws IOException {
        byte[] content = PlySamples.binary("float", ByteOrder.BIG_ENDIAN, 4);
        int data = content.length - 14 - 36;
        ByteBuffer.wrap(content).putFloat(data + 24, Float.NaN);
        assertThat(Reading.refusal("a.ply", content))
                .hasMessageStartingWith("a.ply, byte " + (data + 28) + ": x of vertex 2 is NaN");
        String header = new String(content, StandardCharsets.ISO_8859_1);
        content[content.length - 14] = 0; // a face of no corners
        content[content.length - 13] = 0;
        assertThat(header).contains("list ushort int");
        ModelFile file = ModelReader.read("a.ply", content, ResourceResolver.NONE);
        assertThat(file.notes()).extracting(Note::example).contains("byte " + (data + 28));
    }
}
