package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ObjReaderTest {
    private static ModelFile read(String... lines) throws IOException {
        return Reading.read("a.obj", lines);
    }

    private static String[] triangle(String... more) {
        String[] all = new String[more.length + 3];
        all[0] = "v 0 0 0";
        all[1] = "v 1 0 0";
        all[2] = "v 0 1 0";
        System.arraycopy(more, 0, all, 3, more.length);
        return all;
    }

    @Test
    void shouldReadFacesWithPositiveAndNegativeIndices() throws IOException {
        Mesh mesh = read(triangle("f 1 2 3", "v 2 2 2", "f -1 -2 -3")).mesh();
        assertThat(Reading.corners(mesh)).containsExactly(0, 1, 2, 3, 2, 1);
    }

    @Test
    void shouldReadIndicesOfVerticesThatComeLater() throws IOException {
        assertThat(Reading.faces(
                        read("f 1 2 3", "v 0 0 0", "v 1 0 0", "v 0 1 0").mesh()))
                .containsExactly("0,0,0 1,0,0 0,1,0");
    }

    @Test
    void shouldMarkWhatACornerDoesNotNameAsAbsent() throws IOException {
        Mesh mesh = read(triangle("vt .5 .25", "vn 0 0 1", "f 1 2/1 3//1", "f 1/1/1 2/-1/-1 3/1/"))
                .mesh();
        assertThat(mesh.wedges()).isEqualTo(6);
        assertThat(Reading.at(mesh, Channel.Semantic.TEXCOORD, 0, 0)).isNull();
        assertThat(Reading.at(mesh, Channel.Semantic.TEXCOORD, 0, 1)).containsExactly(.5f, .25f);
        assertThat(Reading.at(mesh, Channel.Semantic.NORMAL, 0, 1)).isNull();
        assertThat(Reading.at(mesh, Channel.Semantic.NORMAL, 0, 2)).containsExactly(0, 0, 1);
        assertThat(Reading.at(mesh, Channel.Semantic.NORMAL, 1, 1)).containsExactly(0, 0, 1);
        assertThat(Reading.at(mesh, Channel.Semantic.NORMAL, 1, 2)).isNull();
    }

    @Test
    void shouldMergeWedgesWithTheSameBitsUnderDifferentIndices() throws IOException {
        Mesh mesh = read(triangle("vn 0 0 1", "vn 0 0 1", "vn -0 0 1", "f 1//1 2//1 3//1", "f 1//2 3//2 2//3"))
                .mesh();
        assertThat(mesh.wedges()).isEqualTo(4);
    }

    @Test
    void shouldLeaveOutChannelsThatNoCornerNames() throws IOException {
        assertThat(read(triangle("vn 0 0 1", "vt 0 0", "f 1 2 3")).mesh().channels())
                .isEmpty();
    }

    @Test
    void shouldKeepVerticesAsTheFileHasThem() throws IOException {
        Mesh mesh = read(triangle("v 0 0 0", "v 9 9 9", "f 1 2 3", "f 4 2 3")).mesh();
        assertThat(mesh.vertices()).isEqualTo(5);
        assertThat(Reading.corners(mesh)).containsExactly(0, 1, 2, 3, 1, 2);
    }

    @Test
    void shouldReadVertexColoursWithAndWithoutAlpha() throws IOException {
        Mesh mesh =
                read("v 0 0 0 1 .5 0", "v 1 0 0 0 0 0 .5", "v 0 1 0", "f 1 2 3").mesh();
        assertThat(Reading.at(mesh, Channel.Semantic.COLOUR, 0, 0)).containsExactly(1, .5f, 0, 1);
        assertThat(Reading.at(mesh, Channel.Semantic.COLOUR, 0, 1)).containsExactly(0, 0, 0, .5f);
        assertThat(Reading.at(mesh, Channel.Semantic.COLOUR, 0, 2)).isNull();
    }

    @Test
    void shouldKeepAThirdTextureCoordinateOnlyWhereItSaysSomething() throws IOException {
        assertThat(read(triangle("vt 1 0 0", "f 1/1 2/1 3/1"))
                        .mesh()
                        .channels()
                        .get(0)
                        .components())
                .isEqualTo(2);
        assertThat(read(triangle("vt 1", "vt 0 0 .5", "f 1/1 2/2 3/2"))
                        .mesh()
                        .channels()
                        .get(0)
                        .components())
                .isEqualTo(3);
    }

    @Test
    void shouldJoinLinesThatEndInABackslash() throws IOException {
        assertThat(read(triangle("f 1 \\", "2 \\", " 3")).mesh().faces()).isEqualTo(1);
    }

    @Test
    void shouldReadEveryLineEnd() throws IOException {
        String text = "v 0 0 0 # comment\rv 1 0 0\r\nv 0 1 0\n\n\r\nf 1 2 3";
        assertThat(Reading.read("a.obj", text).mesh().faces()).isEqualTo(1);
    }

    @Test
    void shouldReportSkippedStatementsByKind() throws IOException {
        ModelFile file = read(triangle(
                "g a", "o b", "s 1", "l 1 2", "p 1", "l 2 3", "deg 3", "curv 0 1 1 2", "bevel on", "f 1 2", "f 1 2 3"));
        assertThat(file.notes())
                .containsExactly(
                        Note.dropped("Points left out: p (1). jSM streams triangles.", 1, "line 8")
                                .asWarning(),
                        Note.dropped("Lines left out: l (2). jSM streams triangles.", 2, "line 7")
                                .asWarning(),
                        Note.dropped(
                                        "Curves and free-form surfaces left out: curv (1), deg (1)."
                                                + " Export the model as polygons to keep them.",
                                        2,
                                        "line 10")
                                .asWarning(),
                        Note.unread("Statements skipped: bevel (1).", 1, "line 12"),
                        Note.dropped("1 face with fewer than three corners left out.", 1, "face 0"));
        assertThat(file.mesh().faces()).isEqualTo(1);
    }

    @Test
    void shouldReadMaterialsOfSeveralLibrariesWithBlanksInTheirNames() throws IOException {
        MemoryFiles files = new MemoryFiles()
                .with("my house.mtl", "newmtl dark  wood\nKd 1 0 0\n\tmap_Kd  wood grain.png \nNs 10")
                .with("b.mtl", "newmtl b\r\n  Kd 0 0 1\r\n  d 0.5\r\n")
                .with("wood grain.png", "WOOD")
                .with(
                        "a.obj",
                        Reading.bytes(triangle(
                                "mtllib my house.mtl b.mtl",
                                "f 1 2 3",
                                "usemtl dark  wood",
                                "f 1 2 3",
                                "usemtl b ",
                                "f 1 2 3",
                                "usemtl",
                                "f 1 2 3")));
        ModelFile file = files.read("a.obj");
        Mesh mesh = file.mesh();
        assertThat(file.notes()).isEmpty();
        assertThat(mesh.faceMaterials()).containsExactly(-1, 0, 1, -1);
        assertThat(mesh.materials().get(0).name()).isEqualTo("dark  wood");
        assertThat(mesh.materials().get(0).parameter("Kd")).containsExactly(1, 0, 0);
        assertThat(mesh.materials().get(0).textures())
                .containsExactly(new Material.TextureReference("map_Kd", "wood grain.png"));
        assertThat(DisplayMaterial.of(mesh.materials().get(1), false).plain()).containsExactly(0, 0, 1, .5f);
        assertThat(mesh.textures()).hasSize(1);
        assertThat(mesh.textures().get(0).bytes()).asString().isEqualTo("WOOD");
    }

    @Test
    void shouldReportMissingLibrariesAndTexturesAndKeepTheReferences() throws IOException {
        MemoryFiles files = new MemoryFiles()
                .with("b.mtl", "newmtl b\nmap_Kd gone.png")
                .with(
                        "a.obj",
                        Reading.bytes(triangle(
                                "mtllib gone.mtl", "mtllib b.mtl", "usemtl ghost", "f 1 2 3", "usemtl b", "f 1 2 3")));
        ModelFile file = files.read("a.obj");
        assertThat(file.notes())
                .containsExactly(
                        Note.dropped(
                                        "Material libraries not found: gone.mtl. Put the file beside the model under this name, and encode it again.",
                                        1,
                                        "gone.mtl")
                                .asWarning(),
                        Note.repaired("Materials without a definition, their names kept: ghost.", 1, "ghost"),
                        Note.dropped(
                                        "Textures not found: gone.png. Put the image beside the model under this name, and encode it again.",
                                        1,
                                        "gone.png")
                                .asWarning());
        assertThat(file.mesh().materials())
                .containsExactly(
                        Material.named("ghost"),
                        new Material(
                                "b",
                                java.util.List.of(),
                                java.util.List.of(new Material.TextureReference("map_Kd", "gone.png"))));
    }

    @Test
    void shouldReportWeightsAndStrayStatements() throws IOException {
        MemoryFiles files = new MemoryFiles()
                .with("l.mtl", "Kd 1 1 1\nNs 2\nnewmtl m")
                .with("a.obj", Reading.bytes(triangle("v 0 0 1 .5", "v 0 0 2 .5", "mtllib l.mtl", "f 1 2 3")));
        assertThat(files.read("a.obj").notes())
                .containsExactly(
                        Note.unread("l.mtl: 2 statements before the first newmtl skipped.", 2, "line 1"),
                        Note.dropped("Weights of vertices (w) left out; they matter to curves alone.", 2, "line 4"));
    }

    @Test
    void shouldTakeTheLastOfTwoDefinitionsAndSaySo() throws IOException {
        MemoryFiles files = new MemoryFiles()
                .with("l.mtl", "newmtl m\nKd 1 1 1\nnewmtl m\nKd 0 0 0")
                .with("a.obj", Reading.bytes(triangle("mtllib l.mtl", "usemtl m", "f 1 2 3")));
        ModelFile file = files.read("a.obj");
        assertThat(file.mesh().materials().get(0).parameter("Kd")).containsExactly(0, 0, 0);
        assertThat(file.notes())
                .containsExactly(Note.dropped("l.mtl: defined more than once, the last definition counts: m.", 1, "m"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "v 1 0|line 4|a vertex of 2 numbers",
                "v 1 0 zero|line 4|z of vertex 4 is \"zero\", not a number",
                "f 1 2 4|line 4|names v number 4 but there are only 3",
                "f 1 2 0|line 4|is 0 where there are 3",
                "f 1 2 -4|line 4|is -4 where there are 3",
                "f 1 2 99999999999|line 4|not a whole number in range",
                "f 1 2 a|line 4|not a whole number in range"
            })
    void shouldRefuseBadLinesByNumber(String line, String place, String reason) {
        ModelFormatException refusal = Reading.refusal("a.obj", triangle(line, "f 1 2 3"));
        assertThat(refusal.place()).isEqualTo(place);
        assertThat(refusal.reason()).contains(reason);
        assertThat(refusal.remedy()).isNotEmpty();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "v 1 nan 0|y of vertex 4 is \"nan\", not a finite number",
                "v 1 0 1e99|z of vertex 4 is \"1e99\", beyond the range of float32",
                "v -1.#IND inf 0|x of vertex 4 is \"-1.#IND\", not a finite number"
            })
    void shouldRefuseAFaceWithAVertexThatIsNoPlace(String vertex, String reason) {
        ModelFormatException refusal = Reading.refusal("a.obj", triangle(vertex, "f 1 2 3", "f 1 2 4"));
        assertThat(refusal.place()).isEqualTo("line 4");
        assertThat(refusal.reason()).isEqualTo(reason);
        assertThat(refusal.remedy()).isNotEmpty();
    }

    @Test
    void shouldRefuseAFileWithoutVertices() {
        assertThat(Reading.refusal("a.obj", "o nothing").reason()).contains("no vertex");
    }
}
