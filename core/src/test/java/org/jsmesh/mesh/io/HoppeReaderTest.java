package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class HoppeReaderTest {
    private static final String TRIANGLE = "Vertex 10  0 0 0\nVertex 5  1 0 0\nVertex 7  0 1 0";

    private static ModelFile read(String... lines) throws IOException {
        return Reading.read("a.m", lines);
    }

    @Test
    void shouldReadVerticesAndFacesUnderAnyNumbers() throws IOException {
        Mesh mesh = read("# comment", TRIANGLE, "Face 99  10 5 7").mesh();
        assertThat(Reading.faces(mesh)).containsExactly("0,0,0 1,0,0 0,1,0");
        assertThat(mesh.channels()).isEmpty();
    }

    @Test
    void shouldPreferNormalsOfCornersToThoseOfVertices() throws IOException {
        Mesh mesh = read(
                        "Vertex 1 0 0 0 {normal=(0 0 1)}",
                        "Vertex 2 1 0 0",
                        "Vertex 3 0 1 0",
                        "Vertex 4 1 1 0",
                        "Face 1 1 2 3",
                        "Face 2 1 3 4",
                        "Corner 1 2 {normal=(1 0 0)}",
                        "Corner 3 2 {normal=(0 1 0)}")
                .mesh();
        assertThat(Reading.at(mesh, Channel.Semantic.NORMAL, 0, 0)).containsExactly(0, 0, 1);
        assertThat(Reading.at(mesh, Channel.Semantic.NORMAL, 0, 1)).isNull();
        assertThat(Reading.at(mesh, Channel.Semantic.NORMAL, 0, 2)).isNull();
        assertThat(Reading.at(mesh, Channel.Semantic.NORMAL, 1, 0)).containsExactly(1, 0, 0);
        assertThat(Reading.at(mesh, Channel.Semantic.NORMAL, 1, 1)).containsExactly(0, 1, 0);
    }

    @Test
    void shouldReadTextureCoordinatesAndColoursOfVertices() throws IOException {
        Mesh mesh = read(
                        "Vertex 1 0 0 0 {rgb=(1 .5 0) uv=(0.25 0.75)}",
                        "Vertex 2 1 0 0",
                        "Vertex 3 0 1 0",
                        "Face 1 1 2 3")
                .mesh();
        assertThat(Reading.at(mesh, Channel.Semantic.COLOUR, 0, 0)).containsExactly(1, .5f, 0);
        assertThat(Reading.at(mesh, Channel.Semantic.TEXCOORD, 0, 0)).containsExactly(.25f, .75f);
    }

    @Test
    void shouldMakeMaterialsOfFaceColoursAndNames() throws IOException {
        ModelFile file = read(
                TRIANGLE,
                "Face 1 10 5 7 {rgb=(1 0.0 0.7)}",
                "Face 2 10 5 7 {rgb=( 1 0 7e-1 )}",
                "Face 3 10 5 7",
                "Face 4 10 5 7 {mat=\"a } b\" rgb=(1 0 .7)}",
                "Face 5 10 5 7 {matid=3 sharp}");
        Mesh mesh = file.mesh();
        assertThat(mesh.faceMaterials()).containsExactly(0, 0, -1, 1, 2);
        assertThat(mesh.materials()).extracting(Material::name).containsExactly("rgb=(1 0 0.7)", "a } b", "matid=3");
        assertThat(mesh.materials().get(1).parameter("rgb")).containsExactly(1, 0, .7f);
        assertThat(file.notes()).containsExactly(Note.unread("Skipped: sharp.", 1, "sharp"));
    }

    @Test
    void shouldGiveACornerOfAPolygonToAllItsTriangles() throws IOException {
        Mesh mesh = read(TRIANGLE, "Vertex 8 -1 .5 0", "Face 1 10 5 7 8", "Corner 10 1 {normal=(0 0 1)}")
                .mesh();
        assertThat(Reading.at(mesh, Channel.Semantic.NORMAL, 0, 0)).containsExactly(0, 0, 1);
        assertThat(Reading.at(mesh, Channel.Semantic.NORMAL, 1, 0)).containsExactly(0, 0, 1);
    }

    @Test
    void shouldReportCornersOfNoFace() throws IOException {
        assertThat(read(TRIANGLE, "Face 1 10 5 7", "Corner 10 2 {normal=(0 0 1)}", "Corner 11 1")
                        .notes())
                .containsExactly(Note.unread("2 Corner lines that name no corner of a face skipped.", 2, "line 5"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "Vertex 10 0 0 0|Vertex 10 appears twice",
                "Vertex 1 0 0|z of Vertex 1 is missing",
                "Vertex 1 0 0 0 0|behind the numbers of a Vertex",
                "Vertex 1 0 0 0 {normal=(0 0 x)}|not 3 numbers in parentheses",
                "Vertex 1 0 0 0 {normal=(0 nan)}|not 3 numbers in parentheses",
                "Vertex 1 0 0 0 {normal=(0 0 1 1)}|not 3 numbers in parentheses",
                "Vertex 1 0 0 0 {normal=(0 0 1|is not closed",
                "Vertex 1 0 0 0 {sharp|a brace is not closed",
                "Face 1 10 5 6|names Vertex 6, which is not above",
                "Face 1 10 5 x|not a whole number",
                "Fish 1|where Vertex, Face or Corner should be"
            })
    void shouldRefuseBadLines(String line, String reason) {
        ModelFormatException refusal = Reading.refusal("a.m", TRIANGLE, line);
        assertThat(refusal.place()).isEqualTo("line 4");
        assertThat(refusal.reason()).contains(reason);
    }

    @Test
    void shouldLeaveOutAttributesThatAreNotFiniteWhereTheyAre() throws IOException {
        ModelFile file = read(
                TRIANGLE,
                "Vertex 1 0 0 0 {normal=(0 0 1) uv=(1e99 0)}",
                "Vertex 2 1 0 0 {normal=(nan 0 0) uv=(1 0)}",
                "Face 9 1 2 5 {rgb=(inf 0 0)}");
        assertThat(Reading.at(file.mesh(), Channel.Semantic.NORMAL, 0, 0)).containsExactly(0, 0, 1);
        assertThat(Reading.at(file.mesh(), Channel.Semantic.NORMAL, 0, 1)).isNull();
        assertThat(Reading.at(file.mesh(), Channel.Semantic.TEXCOORD, 0, 0)).isNull();
        assertThat(file.mesh().faceMaterials()).containsExactly(-1);
        assertThat(file.notes())
                .containsExactly(Note.dropped("3 attributes left out: not finite numbers.", 3, "line 4")
                        .asWarning());
    }
}
