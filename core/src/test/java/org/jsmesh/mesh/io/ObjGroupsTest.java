package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshComparison;
import org.jsmesh.mesh.Note;
import org.junit.jupiter.api.Test;

/** Objects, groups and smoothing groups by face. */
class ObjGroupsTest {
    private static final String VERTICES = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

    private static ModelFile read(String... lines) throws IOException {
        return Reading.read("a.obj", VERTICES + String.join("\n", lines));
    }

    private static List<String> labels(Mesh mesh, String name) {
        List<String> labels = new ArrayList<>();
        for (int f = 0; f < mesh.faces(); f++) labels.add(mesh.faceChannel(name).label(f));
        return labels;
    }

    private static String written(Mesh mesh, String... notes) throws IOException {
        MemoryFiles files = new MemoryFiles();
        assertThat(ModelWriter.write(mesh, ModelFormat.OBJ, "b.obj", files)).containsExactly(notes);
        if (notes.length == 0)
            assertThat(MeshComparison.firstDifference(mesh, files.read("b.obj").mesh()))
                    .isEmpty();
        return files.text("b.obj");
    }

    @Test
    void shouldKeepTheNamesThatEachFaceHas() throws IOException {
        ModelFile file = read(
                "f 1 2 3",
                "o Body",
                "g wheel left",
                "f 1 2 3",
                "g wheel right",
                "f 1 2 3 4",
                "o",
                "f 1 2 3",
                "g",
                "f 1 3 4");
        assertThat(file.notes()).extracting(Note::kind).containsExactly(Note.Kind.CHANGED);
        assertThat(labels(file.mesh(), FaceChannel.OBJECT)).containsExactly("", "Body", "Body", "Body", "", "");
        assertThat(labels(file.mesh(), FaceChannel.GROUP))
                .containsExactly("", "wheel left", "wheel right", "wheel right", "wheel right", "");
        assertThat(file.mesh().faceChannel(FaceChannel.SMOOTHING)).isNull();
    }

    @Test
    void shouldKeepSmoothingGroupsAsNumbers() throws IOException {
        Mesh mesh = read("f 1 2 3", "s 7", "f 1 2 3", "s off", "f 1 2 3", "s on", "f 1 2 3", "s 0", "f 1 2 3")
                .mesh();
        FaceChannel smoothing = mesh.faceChannel(FaceChannel.SMOOTHING);
        assertThat(smoothing.type()).isEqualTo(Channel.Type.INT32);
        assertThat(smoothing.values()).containsExactly(0, 7, 0, 1, 0);
        Mesh large = read("s 4294967295", "f 1 2 3").mesh();
        assertThat(large.faceChannel(FaceChannel.SMOOTHING).exact(0, 0)).isEqualTo(4294967295.0);
        assertThat(written(large)).contains("\ns 4294967295\n");
    }

    @Test
    void shouldKeepOneGroupOfAllFaces() throws IOException {
        Mesh mesh = read("o Suzanne", "s off", "f 1 2 3").mesh();
        assertThat(labels(mesh, FaceChannel.OBJECT)).containsExactly("Suzanne");
        assertThat(written(mesh)).contains("\no Suzanne\ns off\nf 1 2 3\n");
    }

    @Test
    void shouldLeaveOutNamesThatNoFaceHas() throws IOException {
        Mesh mesh = read("g a", "g b", "o", "f 1 2 3", "g c").mesh();
        assertThat(mesh.faceChannels()).hasSize(1);
        assertThat(mesh.faceChannel(FaceChannel.GROUP).labels()).containsExactly("b");
    }

    @Test
    void shouldTellASmoothingGroupThatIsNoNumber() throws IOException {
        ModelFile file = read("s round", "f 1 2 3", "s -1", "f 1 2 3", "s 99999999999", "f 1 2 3");
        assertThat(file.mesh().faceChannel(FaceChannel.SMOOTHING).values()).containsExactly(0, 0, 0);
        assertThat(file.notes())
                .containsExactly(Note.unread(
                        "Smoothing groups that are no number, read as off: round, -1, 99999999999.", 3, "round"));
    }

    @Test
    void shouldWriteEachNameOnceForARunOfFaces() throws IOException {
        Mesh mesh = read("s 1", "g a", "f 1 2 3", "f 1 3 4", "g b c", "f 1 2 4", "s off", "f 2 3 4", "g", "f 1 2 3")
                .mesh();
        assertThat(written(mesh))
                .endsWith("g a\ns 1\nf 1 2 3\nf 1 3 4\ng b c\ns off\nf 2 3 4\ns 1\nf 1 2 4\ng\ns off\nf 1 2 3\n");
    }

    @Test
    void shouldWriteFacesOfAGroupTogetherWhateverTheirOrderInTheMesh() throws IOException {
        Mesh mesh = new MeshBuilder()
                .positions(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0})
                .faceWedges(new int[] {0, 1, 2, 0, 2, 3, 0, 1, 3, 1, 2, 3, 0, 2, 1})
                .faceChannels(List.of(new FaceChannel(
                        FaceChannel.GROUP, 1, Channel.Type.INT32, new int[] {1, 0, 1, 0, 1}, List.of("a", "b"))))
                .build();
        assertThat(written(mesh)).endsWith("\ng a\nf 1 3 4\nf 2 3 4\ng b\nf 1 2 3\nf 1 2 4\nf 1 3 2\n");
    }

    @Test
    void shouldKeepGroupsAcrossMaterials() throws IOException {
        Mesh mesh = read("usemtl m", "g a", "f 1 2 3", "usemtl", "f 1 3 4", "g b", "f 1 2 4", "usemtl m", "f 2 3 4")
                .mesh();
        assertThat(labels(mesh, FaceChannel.GROUP)).containsExactly("a", "a", "b", "b");
        written(mesh);
    }

    @Test
    void shouldNotLetNamesBreakOutOfTheirLine() throws IOException {
        Mesh mesh = group("evil\nv 9 9 9", " evil_v 9 9 9 ");
        assertThat(written(
                        mesh,
                        "Groups and objects written under other names: evil?v 9 9 9 as evil_v 9 9 9,"
                                + "  evil_v 9 9 9  as evil_v 9 9 9-2."))
                .contains("\ng evil_v 9 9 9\n", "\ng evil_v 9 9 9-2\n");
    }

    @Test
    void shouldSayWhichAttributesOfFacesItDoesNotHold() throws IOException {
        Mesh mesh = MeshBuilder.from(group("a", "b"))
                .faceChannels(List.of(
                        new FaceChannel("quality", 1, Channel.Type.FLOAT32, new int[2], List.of()),
                        new FaceChannel(FaceChannel.SMOOTHING, 1, Channel.Type.FLOAT32, new int[2], List.of())))
                .build();
        written(mesh, "OBJ does not hold these attributes of faces: quality, smoothing.");
    }

    private static Mesh group(String first, String second) {
        return new MeshBuilder()
                .positions(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0})
                .faceWedges(new int[] {0, 1, 2, 0, 2, 1})
                .faceChannels(List.of(new FaceChannel(
                        FaceChannel.GROUP, 1, Channel.Type.INT32, new int[] {0, 1}, List.of(first, second))))
                .build();
    }
}
