package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class OffReaderTest {
    @ParameterizedTest
    @ValueSource(
            strings = {"OFF\n3 1 0", "OFF 3 1 0", "# c\nOFF # c\n\n# c\n3 1 0 # c", "off\n3 1 0", "3 1 0", "OFF\n3 1"})
    void shouldReadEveryHeader(String header) throws IOException {
        if (header.endsWith("3 1")) header += " 3";
        Mesh mesh = Reading.read("a.off", header, "0 0 0", "1 0 0 # c", "", "0 1 0", "3 0 1 2")
                .mesh();
        assertThat(Reading.faces(mesh)).containsExactly("0,0,0 1,0,0 0,1,0");
    }

    @Test
    void shouldReadNormalsColoursAndTextureCoordinates() throws IOException {
        Mesh mesh = Reading.read(
                        "a.off",
                        "STCNOFF",
                        "3 1 0",
                        "0 0 0 0 0 1 255 0 0 .5 1",
                        "1 0 0 0 0 1 0 51 0 0 0",
                        "0 1 0 0 0 1 0 0 0 0 0",
                        "3 0 1 2")
                .mesh();
        assertThat(Reading.at(mesh, Channel.Semantic.NORMAL, 0, 1)).containsExactly(0, 0, 1);
        assertThat(Reading.at(mesh, Channel.Semantic.COLOUR, 0, 1)).containsExactly(0, .2f, 0);
        assertThat(Reading.at(mesh, Channel.Semantic.TEXCOORD, 0, 0)).containsExactly(.5f, 1);
        assertThat(mesh.channel(Channel.Semantic.COLOUR).type()).isEqualTo(Channel.Type.UINT8);
    }

    @Test
    void shouldReadColoursOfFloatsWithAlpha() throws IOException {
        Mesh mesh = Reading.read(
                        "a.off", "COFF", "3 1 0", "0 0 0 1 0 0 1", "1 0 0 0 .5 0 1", "0 1 0 0 0 0 0", "3 0 1 2")
                .mesh();
        assertThat(Reading.at(mesh, Channel.Semantic.COLOUR, 0, 1)).containsExactly(0, .5f, 0, 1);
    }

    @Test
    void shouldMakeMaterialsOfFaceColours() throws IOException {
        Mesh mesh = Reading.read(
                        "a.off",
                        "OFF",
                        "3 5 0",
                        "0 0 0",
                        "1 0 0",
                        "0 1 0",
                        "3 0 1 2 1.0 0.5 0",
                        "3 0 1 2",
                        "3 0 1 2 255 0 51",
                        "3 0 1 2 7",
                        "3 0 1 2 1 .5 0")
                .mesh();
        assertThat(mesh.faceMaterials()).containsExactly(0, -1, 1, 2, 0);
        assertThat(mesh.materials().get(0).parameter("rgb")).containsExactly(1, .5f, 0);
        assertThat(mesh.materials().get(1).parameter("rgb")).containsExactly(1, 0, .2f);
    }

    @Test
    void shouldSkipNumbersThatTheKeywordDoesNotPromise() throws IOException {
        ModelFile file = Reading.read("a.off", "OFF", "3 1 0", "0 0 0 9 9 9", "1 0 0 9 9 9", "0 1 0 9 9 9", "3 0 1 2");
        assertThat(Reading.faces(file.mesh())).containsExactly("0,0,0 1,0,0 0,1,0");
        assertThat(file.notes())
                .containsExactly(
                        Note.unread("3 more numbers per vertex than the keyword says: skipped.", 3, "vertex 0"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "OFF/2000000000 1 0|cannot be in the",
                "OFF/3 -1 0|the number of faces is -1",
                "OFF/1 1 0/0 0 nan/3 0 0 0|z of vertex 0 is \"nan\", not a finite number",
                "OFF/3 1 0/0 0 0/1 0 0/0 1 0/3 0 1 3|names vertex 3 of 3",
                "OFF/3 1 0/0 0 0/1 0 0/0 1 0/99 0 1 3|has 99 corners",
                "OFF/3 1 0/0 0 0/1 0 0/0 1 0/3 0 1|a corner of face 0 is missing",
                "OFF/3 1 0/0 0 0/1 0 0/0 1 0/3 0 1 x|not a whole number",
                "OFF/3 1 0/0 0 0/1 0 0|cannot be in the",
                "OFF BINARY/x|binary OFF is not read",
                "4OFF/3 1 0|\"4OFF\" holds vertices of four coordinates, and jSM reads those of three",
                "4nOFF/3 1 0|\"4nOFF\" holds vertices of any number of dimensions",
                "nOFF/3 1 0|\"nOFF\" holds vertices of any number of dimensions, and jSM reads those of three",
                "CnOFF/3 1 0|\"CnOFF\" holds vertices of any number of dimensions",
                "COFF/1 0 0/0 0 0 1 2|2 numbers of colour",
                "OFF|the number of vertices is missing",
                "OFF 3|the number of faces is missing",
                "OFFx/3 1 0/0 0 0|the number of vertices is \"OFFx\""
            })
    void shouldRefuseBadFiles(String lines, String reason) {
        assertThat(Reading.refusal("a.off", lines.split("/")).reason()).contains(reason);
    }
}
