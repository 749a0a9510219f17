package org.jsmesh.memory;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.zip.GZIPOutputStream;
import org.jsmesh.encode.EncoderSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What fits must not be refused, whatever its header and its length look like. */
class LeastMemoryTest {
    private static final int FACES = 1000;
    private static final String ACCESSORS = "\"accessors\":[{\"count\":100,\"type\":\"VEC3\"},{\"count\":" + 3 * FACES
            + ",\"type\":\"SCALAR\"},{\"count\":7},{\"count\":5}]";
    private static final String MESH =
            "{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"NORMAL\":0},\"indices\":1}]}";
    private static final String MESHES = "\"meshes\":[" + MESH + "," + MESH + "]";

    @ParameterizedTest
    @ValueSource(strings = {"solid a", "SOLID a", "\u00ef\u00bb\u00bfsolid", "\n \t solid a"})
    void shouldKnowTextOfStl(String begin) throws IOException {
        boolean large = begin.startsWith("SOLID");
        String facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
        String text = begin + "\n" + (large ? facet.toUpperCase(java.util.Locale.ROOT) : facet).repeat(FACES);
        MemoryEstimate found = of("a.stl", text.getBytes(StandardCharsets.ISO_8859_1));
        assertThat(found.faces()).isEqualTo(FACES);
        assertThat(found.leastBytes()).isBetween(1L, least(FACES));
    }

    @Test
    void shouldNotTakeFillingForTriangles() throws IOException {
        byte[] filled = Arrays.copyOf(stl(FACES), 1 << 20);
        assertThat(of("a.stl", filled).leastBytes()).isLessThanOrEqualTo(least(FACES));
    }

    @Test
    void shouldNotTakeCommentsForCorners() throws IOException {
        String text = "v 0 0 0\n".repeat(3) + "f 1 2 3 # one two three four five six\n".repeat(FACES);
        MemoryEstimate found = of("a.obj", text.getBytes(StandardCharsets.UTF_8));
        assertThat(found.faces()).isEqualTo(FACES);
        assertThat(found.leastBytes()).isLessThanOrEqualTo(least(FACES));
    }

    @Test
    void shouldCountTheSceneThatIsShown() throws IOException {
        String nodes = "\"nodes\":[{\"mesh\":0,\"children\":[1,2]},{\"mesh\":1,\"extensions\":"
                + "{\"KHR_node_visibility\":{\"visible\":false}},\"children\":[3]},"
                + "{\"mesh\":1,\"extensions\":{\"EXT_mesh_gpu_instancing\":{\"attributes\":{\"A\":2,\"B\":3}}}},"
                + "{\"mesh\":0},{\"mesh\":1}]";
        String scenes = "\"scene\":1,\"scenes\":[{\"nodes\":[4]},{\"extras\":[{}],\"nodes\":[0]}]";
        assertShown(6, "{" + String.join(",", scenes, nodes, MESHES, ACCESSORS) + "}");
        assertShown(7, "{" + String.join(",", ACCESSORS, MESHES, nodes) + "}");
        assertShown(1, "{" + String.join(",", "\"scenes\":[{\"nodes\":[3]}]", ACCESSORS, MESHES, nodes) + "}");
        assertShown(0, "{" + String.join(",", "\"scenes\":[{}]", ACCESSORS, MESHES, nodes) + "}");
    }

    private static void assertShown(int times, String gltf) throws IOException {
        MemoryEstimate found = of("a.gltf", gltf.getBytes(StandardCharsets.UTF_8));
        assertThat(found.faces()).isEqualTo(times * FACES);
        assertThat(found.leastBytes()).isEqualTo(least(times * FACES));
        assertThat(found.channels()).isEqualTo(times == 0 ? 0 : 3);
    }

    @Test
    void shouldNotCountNodesBelowThemselves() throws IOException {
        String nodes = "\"nodes\":[{\"mesh\":0,\"children\":[0,1]},{\"mesh\":1,\"children\":[0]}]";
        String gltf = "{" + String.join(",", "\"scenes\":[{\"nodes\":[0]}]", ACCESSORS, MESHES, nodes) + "}";
        assertThat(of("a.gltf", gltf.getBytes(StandardCharsets.UTF_8)).leastBytes())
                .isZero();
    }

    @Test
    void shouldGuessWhereADescriptionIsLarge() throws IOException {
        String nodes = "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}]";
        String gltf = "{" + String.join(",", nodes, ACCESSORS, MESHES) + "}";
        assertShown(1, gltf);
        byte[] filled = Arrays.copyOf(gltf.getBytes(StandardCharsets.UTF_8), GltfCount.MOST_DESCRIPTION + 1);
        Arrays.fill(filled, gltf.length(), filled.length, (byte) ' ');
        assertThat(of("a.gltf", filled).leastBytes()).isZero();
        String many = "{\"nodes\":[" + "0,".repeat(IntList.MOST) + "0]}";
        assertThat(of("a.gltf", many.getBytes(StandardCharsets.UTF_8)).faces()).isEqualTo(many.length() / 24);
    }

    @Test
    void shouldTakeWhatIsNoTextForAnything() throws IOException {
        byte[] wrong = ("\0\0\0{" + "\u007f".repeat(400)).getBytes(StandardCharsets.ISO_8859_1);
        assertThat(of("a.gltf", wrong).leastBytes()).isZero();
    }

    @Test
    void shouldNotBelieveTheEndOfAGzipFile() throws IOException {
        byte[] packed = gzip(stl(FACES));
        assertThat(of("a.stl.gz", packed).leastBytes()).isEqualTo(least(FACES));
        byte[] behind = Arrays.copyOf(packed, packed.length + 4);
        behind[packed.length + 2] = 1; // 65,536 bytes
        assertThat(of("a.stl.gz", behind).leastBytes()).isLessThanOrEqualTo(least(FACES));
        byte[] glb = glb(5 * FACES);
        assertThat(of("a.glb.gz", gzip(glb)).leastBytes()).isEqualTo(least(5 * FACES));
        byte[] cut = Arrays.copyOf(glb, glb.length - 4);
        assertThat(of("a.glb.gz", gzip(cut)).leastBytes()).isZero();
    }

    @Test
    void shouldSeeMoreThanTheLastPartOfAGzipFile() throws IOException {
        byte[] random = stl(100 * FACES);
        new java.util.Random(1).nextBytes(random);
        System.arraycopy(stl(100 * FACES), 0, random, 0, 84);
        byte[] packed = gzip(random);
        byte[] empty = gzip(new byte[0]);
        byte[] both = Arrays.copyOf(packed, packed.length + empty.length);
        System.arraycopy(empty, 0, both, packed.length, empty.length);
        assertThat(of("a.stl.gz", packed).faces()).isEqualTo(100 * FACES);
        assertThat(of("a.stl.gz", both).faces()).isGreaterThan(100 * FACES);
        assertThat(of("a.stl.gz", both).leastBytes()).isZero();
    }

    @Test
    void shouldLookIntoNoMoreLayersThanTheReader() throws IOException {
        byte[] twice = gzip(gzip(stl(FACES)));
        assertThat(of("a.stl", twice).faces()).isEqualTo(FACES);
        assertThat(of("a.stl", gzip(twice)).faces()).isNotEqualTo(FACES);
        assertThat(of("a.stl", gzip(twice)).leastBytes()).isZero();
    }

    private static MemoryEstimate of(String name, byte[] all) throws IOException {
        return MemoryEstimate.of(name, all.length, ByteRanges.ofStart(all), EncoderSettings.defaults());
    }

    /** Of a binary STL file with so many faces. */
    private static long least(int faces) throws IOException {
        return of("a.stl", stl(faces)).leastBytes();
    }

    private static byte[] stl(int faces) {
        return ByteBuffer.allocate(84 + 50 * faces)
                .order(ByteOrder.LITTLE_ENDIAN)
                .putInt(80, faces)
                .array();
    }

    private static byte[] glb(int faces) {
        String json = "{\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],\"meshes\":[" + MESH
                + "],\"accessors\":[{\"count\":3},{\"count\":" + 3 * faces + "}]}";
        byte[] text = json.getBytes(StandardCharsets.UTF_8);
        ByteBuffer glb = ByteBuffer.allocate(28 + text.length).order(ByteOrder.LITTLE_ENDIAN);
        glb.putInt(0x46546C67).putInt(2).putInt(28 + text.length).putInt(text.length);
        return glb.putInt(0x4E4F534A).put(text).array();
    }

    private static byte[] gzip(byte[] content) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (GZIPOutputStream out = new GZIPOutputStream(bytes)) {
            out.write(content);
        }
        return bytes.toByteArray();
    }
}
