package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.stream.Stream;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Faults in what corners have beside a place cost that, and not the model. */
class ObjFaultsTest {
    private static final String[] CUBE = {
        "v 0 0 0", "v 1 0 0", "v 1 1 0", "v 0 1 0", "v 0 0 1", "v 1 0 1", "v 1 1 1", "v 0 1 1"
    };
    private static final String[] FACES = {
        "f 1 3 2", "f 1 4 3", "f 5 6 7", "f 5 7 8", "f 1 2 6", "f 1 6 5", "f 2 3 7", "f 2 7 6", "f 3 4 8", "f 3 8 7",
        "f 4 1 5", "f 4 5 8"
    };

    private static ModelFile read(String... lines) throws IOException {
        return Reading.read("a.obj", lines);
    }

    private static String[] lines(String[] first, String[] second, String... third) {
        return Stream.of(first, second, third).flatMap(Stream::of).toArray(String[]::new);
    }

    private static String[] faces(String suffix) {
        return Stream.of(FACES)
                .map(face -> face.replaceAll("(\\d)", "$1" + suffix))
                .toArray(String[]::new);
    }

    private static void shouldBeTheCube(Mesh mesh) throws IOException {
        assertThat(Reading.faces(mesh))
                .isEqualTo(Reading.faces(read(lines(CUBE, FACES)).mesh()));
    }

    @Test
    void shouldReadACubeWhoseFacesNameNormalsAndTextureCoordinatesThatAreNotThere() throws IOException {
        ModelFile file = read(lines(CUBE, faces("/1/1")));
        shouldBeTheCube(file.mesh());
        assertThat(file.mesh().channels()).isEmpty();
        assertThat(file.notes())
                .containsExactly(
                        Note.dropped(
                                        "36 corners without normal: they name a vn that is not among the 0 of the file.",
                                        36,
                                        "line 9")
                                .asWarning(),
                        Note.dropped(
                                        "36 corners without texture coordinate: they name a vt that is not among the 0 of the file.",
                                        36,
                                        "line 9")
                                .asWarning());
    }

    @ParameterizedTest
    @ValueSource(strings = {"0", "2", "-2", "99999999999", "x", "1.5", "1/1"})
    void shouldLeaveOneCornerWithoutTheNormalThatItsIndexDoesNotGive(String index) throws IOException {
        String[] faces = faces("//1");
        faces[3] = "f 5//" + index + " 7//1 8//1";
        ModelFile file = read(lines(new String[] {"vn 0 0 1"}, CUBE, faces));
        shouldBeTheCube(file.mesh());
        assertThat(Reading.at(file.mesh(), Channel.Semantic.NORMAL, 3, 0)).isNull();
        assertThat(Reading.at(file.mesh(), Channel.Semantic.NORMAL, 3, 1)).containsExactly(0, 0, 1);
        assertThat(Reading.at(file.mesh(), Channel.Semantic.NORMAL, 2, 0)).containsExactly(0, 0, 1);
        assertThat(file.notes())
                .containsExactly(Note.dropped(
                                "1 corner without normal: it names a vn that is not among the 1 of the file.",
                                1,
                                "line 13")
                        .asWarning());
    }

    @Test
    void shouldFindTheRowOfAnIndexThatCountsForward() throws IOException {
        ModelFile file = read(lines(CUBE, faces("/2"), "vt 0 0", "vt .5 1"));
        assertThat(file.notes()).isEmpty();
        assertThat(Reading.at(file.mesh(), Channel.Semantic.TEXCOORD, 11, 2)).containsExactly(.5f, 1);
    }

    @ParameterizedTest
    @ValueSource(strings = {"vn nan 0 1", "vn 0 0 -inf", "vn 0 1e99 0", "vn 0 1", "vn", "vn a b c", "vn 0 0 -1.#IND"})
    void shouldLeaveOutANormalThatIsNoneAndKeepTheOthers(String row) throws IOException {
        String[] faces = faces("//1");
        faces[0] = "f 1//2 3//2 2//1";
        ModelFile file = read(lines(CUBE, new String[] {"vn 0 0 1", row}, faces));
        shouldBeTheCube(file.mesh());
        assertThat(Reading.at(file.mesh(), Channel.Semantic.NORMAL, 0, 1)).isNull();
        assertThat(Reading.at(file.mesh(), Channel.Semantic.NORMAL, 0, 2)).containsExactly(0, 0, 1);
        assertThat(file.notes())
                .containsExactly(Note.dropped("1 normal (vn) that is incomplete or not finite left out.", 1, "line 10")
                        .asWarning());
    }

    @Test
    void shouldLeaveOutTextureCoordinatesThatAreNone() throws IOException {
        ModelFile file = read(lines(CUBE, new String[] {"vt 0 0", "vt inf 0", "vt 0 nan", "vt"}, faces("/2")));
        shouldBeTheCube(file.mesh());
        assertThat(file.mesh().channels()).isEmpty();
        assertThat(file.notes())
                .containsExactly(Note.dropped(
                                "3 texture coordinates (vt) that are incomplete or not finite left out.", 3, "line 10")
                        .asWarning());
    }

    @ParameterizedTest
    @ValueSource(strings = {"v nan nan nan", "v 0 inf 0", "v -1.#QNAN 0 0", "v 0 0 1e99"})
    void shouldLeaveOutAVertexThatIsNoPlaceAndThatNoFaceUses(String vertex) throws IOException {
        String[] late = {"v 9 9 9", "f -1 1 2"};
        ModelFile file = read(lines(CUBE, new String[] {vertex}, lines(FACES, late)));
        assertThat(file.mesh().vertices()).isEqualTo(9);
        assertThat(file.mesh().bounds()).containsExactly(0, 0, 0, 9, 9, 9);
        assertThat(Reading.faces(file.mesh())).hasSize(13).last().isEqualTo("9,9,9 0,0,0 1,0,0");
        assertThat(file.notes())
                .containsExactly(
                        Note.dropped("1 vertex that is not finite and that no face uses left out.", 1, "line 9"));
    }

    @Test
    void shouldKeepColoursAtTheirVerticesWhereOneIsLeftOut() throws IOException {
        ModelFile file = read("v 0 0 0 1 0 0", "v nan 0 0 0 1 0", "v 1 0 0 0 0 1", "v 0 1 0 1 1 1", "f 1 3 4");
        assertThat(Reading.faces(file.mesh())).containsExactly("0,0,0 1,0,0 0,1,0");
        assertThat(Reading.at(file.mesh(), Channel.Semantic.COLOUR, 0, 1)).containsExactly(0, 0, 1);
    }

    @Test
    void shouldReadThePlaceOfAVertexWithNumbersThatItCannotTell() throws IOException {
        ModelFile file = read("v 0 0 0 1 1", "v 1 0 0 1 1 1 1 1 x", "v 0 1 0", "f 1 2 3");
        assertThat(Reading.faces(file.mesh())).containsExactly("0,0,0 1,0,0 0,1,0");
        assertThat(file.mesh().channels()).isEmpty();
        assertThat(file.notes())
                .containsExactly(Note.unread(
                        "2 vertices of 5 or more than 7 numbers, of which x y z are read; x y z red green blue has 6.",
                        2,
                        "line 1"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"\0", "\0\0\0\0\0\0\0\0", "\u001A", "\u001A\0\0"})
    void shouldLeaveOutWhatFillsAFileUp(String filling) throws IOException {
        byte[] content = (String.join("\n", lines(CUBE, FACES)) + "\n" + filling).getBytes(StandardCharsets.UTF_8);
        ModelFile file = ModelReader.read("a.obj", content, ResourceResolver.NONE);
        shouldBeTheCube(file.mesh());
        int count = filling.length();
        assertThat(file.notes())
                .containsExactly(Note.repaired(
                        count + (count == 1 ? " byte" : " bytes") + " behind the text (NUL or end of file) left out.",
                        count,
                        ""));
    }

    @ParameterizedTest
    @ValueSource(strings = {"\n", "\r\n", "\r"})
    void shouldReadEveryLineEndBehindAMarkOfTheEncoding(String end) throws IOException {
        String text = "\uFEFF" + String.join(end, lines(CUBE, FACES));
        ModelFile file = ModelReader.read("a.obj", text.getBytes(StandardCharsets.UTF_8), ResourceResolver.NONE);
        shouldBeTheCube(file.mesh());
        assertThat(file.notes()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"\\", "\\ ", "\\\t "})
    void shouldJoinLinesWhereBlanksFollowTheBackslash(String end) throws IOException {
        assertThat(Reading.faces(
                        read(lines(CUBE, new String[] {"f 1 2" + end, "3"})).mesh()))
                .containsExactly("0,0,0 1,0,0 1,1,0");
    }
}
