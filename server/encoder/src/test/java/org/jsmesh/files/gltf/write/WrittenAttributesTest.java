package org.jsmesh.files.gltf.write;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.stream.IntStream;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Channel.Semantic;
import org.jsmesh.mesh.Channel.Type;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshComparison;
import org.junit.jupiter.api.Test;

/** How channels become attributes of glTF and back. */
class WrittenAttributesTest {
    /** Two triangles without a common wedge. */
    private static MeshBuilder twoFaces() {
        return new MeshBuilder()
                .positions(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, .1f, 3, 0, 1, 0, -2, 1})
                .faceWedges(new int[] {0, 1, 2, 3, 4, 5});
    }

    private static Channel floats(Semantic semantic, String name, int components, float... values) {
        int[] bits = new int[values.length];
        Arrays.setAll(bits, i -> Float.floatToRawIntBits(values[i]));
        return new Channel(semantic, name, components, Type.FLOAT32, bits, null);
    }

    private static Channel whole(Semantic semantic, String name, int components, Type type, int... values) {
        return new Channel(semantic, name, components, type, values, null);
    }

    private static int[] counted(int n, int first) {
        return IntStream.range(first, first + n).toArray();
    }

    private static List<String> names(JsonNode attributes) {
        List<String> names = new ArrayList<>();
        attributes.fieldNames().forEachRemaining(names::add);
        return names;
    }

    private static List<String> names(Mesh mesh) {
        return mesh.channels().stream().map(Channel::name).toList();
    }

    @Test
    void shouldWriteAttributesOnlyWhereFacesHaveThem() throws IOException {
        BitSet second = new BitSet();
        second.set(3, 6);
        int[] up = new int[18];
        for (int w = 0; w < 3; w++) up[3 * w + 2] = Float.floatToRawIntBits(1);
        Mesh mesh = twoFaces()
                .channels(List.of(new Channel(Semantic.NORMAL, "NORMAL", 3, Type.FLOAT32, up, second)))
                .build();
        GlbFile file = GlbFile.of(mesh);
        assertThat(names(file.primitive(0).path("attributes"))).containsExactly("POSITION", "NORMAL");
        assertThat(names(file.primitive(1).path("attributes"))).containsExactly("POSITION");
        for (int p = 0; p < 2; p++) {
            JsonNode positions =
                    file.accessor(file.primitive(p).path("attributes").path("POSITION"));
            assertThat(positions.path("count").intValue()).isEqualTo(3);
        }
        JsonNode normals = file.accessor(file.primitive(0).path("attributes").path("NORMAL"));
        assertThat(normals.path("count").intValue()).isEqualTo(3);
        assertThat(normals.has("extras")).isFalse();
        JsonNode second3 = file.accessor(file.primitive(1).path("attributes").path("POSITION"));
        assertThat(second3.path("min")).hasToString("[0,-2,0.1]");
        assertThat(second3.path("max")).hasToString("[3,0,1]");
        assertThat(MeshComparison.firstDifference(mesh, file.read())).isEmpty();
    }

    @Test
    void shouldWriteIndicesOfTheSmallestTypeWithoutItsLargestNumber() throws IOException {
        assertThat(indexType(255)).isEqualTo(5121);
        assertThat(indexType(256)).isEqualTo(5123);
        assertThat(indexType(65535)).isEqualTo(5123);
        assertThat(indexType(65536)).isEqualTo(5125);
    }

    private static int indexType(int vertices) throws IOException {
        float[] positions = new float[3 * vertices];
        for (int i = 0; i < positions.length; i++) positions[i] = i;
        int[] faces = new int[3 * (vertices - 2)];
        for (int i = 0; i < faces.length; i++) faces[i] = i / 3 + i % 3;
        GlbFile file = GlbFile.of(
                new MeshBuilder().positions(positions).faceWedges(faces).build());
        JsonNode indices = file.accessor(file.primitive(0).path("indices"));
        int type = indices.path("componentType").intValue();
        int size = type == 5121 ? 1 : type == 5123 ? 2 : 4;
        JsonNode view =
                file.json().path("bufferViews").path(indices.path("bufferView").intValue());
        assertThat(view.path("byteLength").intValue()).isEqualTo(size * faces.length);
        assertThat(view.path("target").intValue()).isEqualTo(34963);
        assertThat(view.has("byteStride")).isFalse();
        return type;
    }

    @Test
    void shouldWriteColoursOfAScreenAsLinearLightAndBringThemBack() throws IOException {
        int[] levels = new int[4 * 255];
        for (int i = 0; i < levels.length; i++) levels[i] = i % 4 == 3 ? i / 4 : (i / 4 + 60 * (i % 4)) % 256;
        float[] positions = new float[3 * 255];
        for (int i = 0; i < positions.length; i++) positions[i] = i * i;
        Mesh mesh = new MeshBuilder()
                .positions(positions)
                .faceWedges(counted(255, 0))
                .channels(List.of(whole(Semantic.COLOUR, "colour", 4, Type.UINT8, levels)))
                .build();
        GlbFile file = GlbFile.of(mesh);
        JsonNode colours = file.accessor(file.primitive(0).path("attributes").path("COLOR_0"));
        assertThat(colours.path("componentType").intValue()).isEqualTo(5123);
        assertThat(colours.path("normalized").booleanValue()).isTrue();
        // sRGB 188 is .50289 of full light; opacity is no light
        int red = file.binary().getShort(file.start(colours) + 8 * 188) & 0xFFFF;
        int opacity = file.binary().getShort(file.start(colours) + 8 * 188 + 6) & 0xFFFF;
        assertThat(red).isEqualTo(32957);
        assertThat(opacity).isEqualTo(188 * 257);
        assertThat(MeshComparison.firstDifference(mesh, file.read())).isEmpty();
        assertThat(names(file.read())).containsExactly("colour");
    }

    @Test
    void shouldBringBackEveryLevelOfAScreen() throws IOException {
        for (int level = 0; level < 256; level++) {
            int[] grey = new int[18];
            Arrays.fill(grey, level);
            Mesh mesh = twoFaces()
                    .channels(List.of(whole(Semantic.COLOUR, "colour", 3, Type.UINT8, grey)))
                    .build();
            assertThat(GlbFile.of(mesh).read().channels().get(0).values()[0]).isEqualTo(level);
        }
    }

    @Test
    void shouldWriteColoursOfGltfAsTheyAre() throws IOException {
        Mesh mesh = twoFaces()
                .channels(List.of(whole(Semantic.COLOUR, "COLOR_0", 3, Type.UINT8, counted(18, 200))))
                .build();
        GlbFile file = GlbFile.of(mesh);
        JsonNode colours = file.accessor(file.primitive(0).path("attributes").path("COLOR_0"));
        assertThat(colours.path("componentType").intValue()).isEqualTo(5121);
        assertThat(colours.has("extras")).isFalse();
        int stride = file.json()
                .path("bufferViews")
                .path(colours.path("bufferView").intValue())
                .path("byteStride")
                .intValue();
        assertThat(stride).isEqualTo(4);
        assertThat(file.binary().getInt(file.start(colours) + 4)).isEqualTo(203 | 204 << 8 | 205 << 16);
        assertThat(MeshComparison.firstDifference(mesh, file.read())).isEmpty();
    }

    @Test
    void shouldShowColoursFrom0To255AndKeepTheirNumbers() throws IOException {
        float[] values = new float[18];
        values[0] = 255;
        values[2] = 51;
        Mesh mesh = twoFaces()
                .channels(List.of(floats(Semantic.COLOUR, "colour", 3, values)))
                .build();
        GlbFile file = GlbFile.of(mesh);
        JsonNode attributes = file.primitive(0).path("attributes");
        assertThat(names(attributes)).containsExactly("POSITION", "_COLOUR", "COLOR_0");
        JsonNode shown = file.accessor(attributes.path("COLOR_0"));
        assertThat(file.binary().getShort(file.start(shown)) & 0xFFFF).isEqualTo(65535);
        // sRGB 51 is .0331 of full light
        assertThat(file.binary().getShort(file.start(shown) + 4) & 0xFFFF).isEqualTo(2170);
        assertThat(file.notes()).isEmpty();
        assertThat(MeshComparison.firstDifference(mesh, file.read())).isEmpty();
    }

    @Test
    void shouldWriteNormalsOfUnitLengthAndKeepTheOthers() throws IOException {
        float[] long3 = {0, 0, 2, 0, 3, 0, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
        Mesh mesh = twoFaces()
                .channels(List.of(floats(Semantic.NORMAL, "normal", 3, long3)))
                .build();
        GlbFile file = GlbFile.of(mesh);
        assertThat(names(file.primitive(0).path("attributes"))).containsExactly("POSITION", "_NORMAL", "NORMAL");
        assertThat(names(file.primitive(1).path("attributes"))).containsExactly("POSITION", "_NORMAL");
        JsonNode shown = file.accessor(file.primitive(0).path("attributes").path("NORMAL"));
        assertThat(file.binary().getFloat(file.start(shown) + 8)).isEqualTo(1);
        assertThat(MeshComparison.firstDifference(mesh, file.read())).isEmpty();
    }

    @Test
    void shouldBringBackChannelsOfEveryTypeInTheirOrder() throws IOException {
        int[] doubles = new int[12];
        for (int w = 0; w < 6; w++) doubles[2 * w + 1] = (int) (Double.doubleToRawLongBits(w + .5) >>> 32);
        Mesh mesh = twoFaces()
                .channels(List.of(
                        floats(Semantic.CUSTOM, "temperature of day", 1, 6, 5, 4, 3, 2, 1),
                        floats(Semantic.CUSTOM, "Temperature.of-day", 1, 1, 2, 3, 4, 5, 6),
                        whole(Semantic.CUSTOM, "a", 2, Type.INT8, counted(12, -6)),
                        whole(Semantic.CUSTOM, "b", 3, Type.UINT16, counted(18, 65500)),
                        whole(Semantic.CUSTOM, "c", 1, Type.INT16, counted(6, -32768)),
                        whole(Semantic.CUSTOM, "d", 1, Type.INT32, counted(6, -3)),
                        whole(Semantic.CUSTOM, "e", 1, Type.UINT32, counted(6, 1 << 20)),
                        new Channel(Semantic.CUSTOM, "f", 1, Type.FLOAT64, doubles, null),
                        whole(Semantic.NORMAL, "n", 3, Type.INT8, counted(18, 100)),
                        whole(Semantic.TEXCOORD, "uv", 2, Type.UINT8, counted(12, 3)),
                        whole(Semantic.TEXCOORD, "uv1", 2, Type.INT16, counted(12, 3)),
                        floats(Semantic.TEXCOORD, "uvw", 3, new float[18]),
                        whole(Semantic.COLOUR, "grey", 1, Type.UINT8, counted(6, 9)),
                        whole(Semantic.COLOUR, "deep", 3, Type.UINT16, counted(18, 9))))
                .build();
        GlbFile file = GlbFile.of(mesh);
        assertThat(file.notes()).isEmpty();
        assertThat(names(file.primitive(0).path("attributes")))
                .contains("_TEMPERATURE_OF_DAY", "_TEMPERATURE_OF_DAY_2", "_A", "_D", "TEXCOORD_1", "COLOR_0");
        Mesh read = file.read();
        assertThat(names(read)).isEqualTo(names(mesh));
        for (int c = 0; c < mesh.channels().size(); c++) {
            assertThat(read.channels().get(c).semantic())
                    .isEqualTo(mesh.channels().get(c).semantic());
            assertThat(read.channels().get(c).type())
                    .isEqualTo(mesh.channels().get(c).type());
        }
        assertThat(MeshComparison.firstDifference(mesh, read)).isEmpty();
    }

    @Test
    void shouldWriteAttributesOfGltfAsTheFileHadThem() throws IOException {
        Mesh mesh = twoFaces()
                .channels(List.of(
                        whole(Semantic.NORMAL, "NORMAL", 3, Type.INT8, counted(18, 100)),
                        whole(Semantic.TEXCOORD, "TEXCOORD_0", 2, Type.UINT16, counted(12, 100)),
                        whole(Semantic.CUSTOM, "JOINTS_0", 4, Type.UINT8, counted(24, 0)),
                        floats(Semantic.CUSTOM, "TANGENT", 4, new float[24]),
                        whole(Semantic.CUSTOM, "WEIGHTS_0 normalized", 4, Type.UINT8, counted(24, 0)),
                        whole(Semantic.CUSTOM, "_X normalized", 1, Type.INT16, counted(6, 0)),
                        whole(Semantic.CUSTOM, "_y", 2, Type.UINT8, counted(12, 0))))
                .build();
        GlbFile file = GlbFile.of(mesh);
        JsonNode attributes = file.primitive(0).path("attributes");
        assertThat(names(attributes))
                .containsExactly("POSITION", "NORMAL", "TEXCOORD_0", "JOINTS_0", "TANGENT", "WEIGHTS_0", "_X", "_y");
        for (String name : List.of("NORMAL", "TEXCOORD_0", "WEIGHTS_0", "_X"))
            assertThat(file.accessor(attributes.path(name)).path("normalized").booleanValue())
                    .as(name)
                    .isTrue();
        for (String name : List.of("JOINTS_0", "_y"))
            assertThat(file.accessor(attributes.path(name)).has("normalized"))
                    .as(name)
                    .isFalse();
        assertThat(file.json().findValue("extras")).isNull();
        assertThat(file.json().path("extensionsRequired")).hasToString("[\"KHR_mesh_quantization\"]");
        Mesh read = file.read();
        assertThat(names(read)).isEqualTo(names(mesh));
        assertThat(MeshComparison.firstDifference(mesh, read)).isEmpty();
    }

    @Test
    void shouldNumberSetsOfAPrimitiveWithoutGaps() throws IOException {
        BitSet second = new BitSet();
        second.set(3, 6);
        Mesh mesh = twoFaces()
                .channels(List.of(
                        new Channel(Semantic.TEXCOORD, "uv", 2, Type.FLOAT32, new int[12], second),
                        floats(Semantic.TEXCOORD, "uv1", 2, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11)))
                .build();
        GlbFile file = GlbFile.of(mesh);
        assertThat(names(file.primitive(0).path("attributes"))).containsExactly("POSITION", "TEXCOORD_0", "TEXCOORD_1");
        assertThat(names(file.primitive(1).path("attributes"))).containsExactly("POSITION", "_TEXCOORD_1");
        assertThat(MeshComparison.firstDifference(mesh, file.read())).isEmpty();
    }
}
