package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshComparison;
import org.jsmesh.mesh.Note;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Values of a PLY file's own meaning, by vertex and by face: kept under their names, with their types. */
class PlyScalarsTest {
    private static String[] square(String vertexProperty, String[] values, String faceProperty, String... faces) {
        String[] lines = PlySamples.square(faces);
        if (vertexProperty != null) lines[5] += '\n' + vertexProperty;
        for (int i = 0; i < 4 && values != null; i++) lines[9 + i] += ' ' + values[i];
        lines[6] = "element face " + faces.length;
        if (faceProperty != null) lines[7] += '\n' + faceProperty;
        return lines;
    }

    private static void assertComesBack(Mesh mesh) throws IOException {
        MemoryFiles files = new MemoryFiles();
        assertThat(ModelWriter.write(mesh, ModelFormat.PLY, "b.ply", files)).isEmpty();
        ModelFile again = files.read("b.ply");
        assertThat(again.notes()).isEmpty();
        assertThat(MeshComparison.firstDifference(mesh, again.mesh())).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({
        "char,INT8,-128,127",
        "uchar,UINT8,0,255",
        "short,INT16,-32768,32767",
        "ushort,UINT16,0,65535",
        "int,INT32,-2147483648,2147483647",
        "uint,UINT32,0,4294967295",
        "float,FLOAT32,-0.1,16777216",
        "double,FLOAT64,0.1,1e300",
        "int64,FLOAT64,-9007199254740991,7",
        "uint64,FLOAT64,0,9007199254740991"
    })
    void shouldKeepScalarsOfVerticesAndFacesWithTheirTypes(String type, Channel.Type kept, String low, String high)
            throws IOException {
        String[] values = {low, high, low, high};
        ModelFile file = Reading.read(
                "a.ply",
                square(
                        "property " + type + " quality",
                        values,
                        "property " + type + " label",
                        "3 0 1 2 " + high,
                        "3 0 2 3 " + low));
        assertThat(file.notes()).isEmpty();
        Channel quality = file.mesh().channels().get(0);
        assertThat(quality.semantic()).isEqualTo(Channel.Semantic.CUSTOM);
        assertThat(quality.name()).isEqualTo("quality");
        assertThat(quality.type()).isEqualTo(kept);
        boolean single = kept == Channel.Type.FLOAT32;
        for (int v = 0; v < 4; v++) {
            double expected = single ? Float.parseFloat(values[v]) : Double.parseDouble(values[v]);
            assertThat(quality.exact(v, 0)).isEqualTo(expected);
        }
        FaceChannel label = file.mesh().faceChannels().get(0);
        assertThat(label.name()).isEqualTo("label");
        assertThat(label.type()).isEqualTo(kept);
        assertThat(label.exact(0, 0)).isEqualTo(single ? Float.parseFloat(high) : Double.parseDouble(high));
        assertThat(label.exact(1, 0)).isEqualTo(single ? Float.parseFloat(low) : Double.parseDouble(low));
        assertComesBack(file.mesh());
    }

    @Test
    void shouldGiveTheTrianglesOfAPolygonItsScalars() throws IOException {
        Mesh mesh = Reading.read(
                        "a.ply", square(null, null, "property uchar label", "4 0 1 2 3 7", "2 0 1 8", "3 0 1 2 9"))
                .mesh();
        assertThat(mesh.faceChannels().get(0).values()).containsExactly(7, 7, 9);
        assertComesBack(mesh);
    }

    @Test
    void shouldGiveTrianglesOfStripsZero() throws IOException {
        String[] lines = square(null, null, "property uchar label", "3 0 1 2", "3 0 2 3 9");
        lines[6] = "element tristrips 1\nproperty list uchar int vertex_indices\nelement face 1";
        assertThat(Reading.read("a.ply", lines).mesh().faceChannels().get(0).values())
                .containsExactly(0, 9);
    }

    @Test
    void shouldKeepWhatIsAbsentAbsent() throws IOException {
        ModelFile file = Reading.read(
                "a.ply",
                square(
                        "property float quality\nproperty double weight",
                        new String[] {"1 nan", "nan 2", "3 3", "4 inf"},
                        null,
                        "3 0 1 2",
                        "3 0 2 3"));
        assertThat(file.notes())
                .containsExactly(
                        Note.dropped("The quality of 1 vertex left out: not finite numbers.", 1, "vertex 1"),
                        Note.dropped("The weight of 2 vertices left out: not finite numbers.", 2, "vertex 0"));
        Channel quality = file.mesh().channels().get(0);
        assertThat(List.of(quality.isAbsent(0), quality.isAbsent(1))).containsExactly(false, true);
        MemoryFiles files = new MemoryFiles();
        assertThat(ModelWriter.write(file.mesh(), ModelFormat.PLY, "b.ply", files))
                .isEmpty();
        assertThat(MeshComparison.firstDifference(
                        file.mesh(), files.read("b.ply").mesh()))
                .isEmpty();
    }

    @Test
    void shouldTellOfWholeNumbersThatNoTypeHolds() throws IOException {
        String[] values = {"1", "9007199254740993", "3", "18446744073709551615"};
        ModelFile file = Reading.read("a.ply", square("property uint64 id", values, null, "3 0 1 2"));
        assertThat(file.notes()).containsExactly(Note.changed("2 id values rounded to float64.", 2, "vertex 1"));
    }

    @Test
    void shouldKeepPropertiesThatAreOnlyPartOfAnAttribute() throws IOException {
        Mesh mesh = Reading.read(
                        "a.ply",
                        square(
                                "property float nx\nproperty uchar red\nproperty uchar green\nproperty uchar blue"
                                        + "\nproperty float alpha",
                                new String[] {"1 2 3 4 .5", "1 2 3 4 .5", "1 2 3 4 .5", "1 2 3 4 .5"},
                                null,
                                "3 0 1 2"))
                .mesh();
        assertThat(mesh.channels()).extracting(Channel::name).containsExactly("colour", "nx", "alpha");
    }

    @Test
    void shouldNameWhatPlyDoesNotHold() throws IOException {
        Channel.Type floats = Channel.Type.FLOAT32;
        Mesh mesh = new MeshBuilder()
                .positions(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0})
                .faceWedges(new int[] {0, 1, 2})
                .channels(List.of(
                        new Channel(Channel.Semantic.CUSTOM, "my weight", 1, floats, new int[3], null),
                        new Channel(Channel.Semantic.CUSTOM, "x", 1, floats, new int[3], null),
                        new Channel(Channel.Semantic.CUSTOM, "_pair", 2, floats, new int[] {1, 2, 3, 4, 5, 6}, null)))
                .faceChannels(List.of(
                        new FaceChannel(FaceChannel.GROUP, 1, Channel.Type.INT32, new int[1], List.of("left")),
                        new FaceChannel("red", 1, floats, new int[1], List.of())))
                .build();
        MemoryFiles files = new MemoryFiles();
        assertThat(ModelWriter.write(mesh, ModelFormat.PLY, "b.ply", files))
                .containsExactly(
                        "PLY holds attributes by single numbers, and each number of these is one by itself: _pair.",
                        "PLY does not hold these attributes of faces: group, red.",
                        "PLY does not hold these channels: my weight, x.");
        assertThat(files.read("b.ply").mesh().channels())
                .extracting(Channel::name)
                .containsExactly("_pair_0", "_pair_1");
    }
}
