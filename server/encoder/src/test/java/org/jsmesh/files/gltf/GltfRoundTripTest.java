package org.jsmesh.files.gltf;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.jsmesh.files.gltf.write.GltfWriter;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshComparison;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.Texture;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.mesh.io.ModelFile;
import org.jsmesh.mesh.io.ModelFormat;
import org.jsmesh.mesh.io.ResourceResolver;
import org.jsmesh.test.SampleModels;
import org.junit.jupiter.api.Test;

class GltfRoundTripTest {
    private static final int WEDGES = 60;
    private final Random random = new Random(11);

    private float[] floats(int count) {
        float[] values = new float[count];
        for (int i = 0; i < count; i++) values[i] = (float) random.nextGaussian();
        values[0] = -0f;
        values[1] = Float.MIN_VALUE;
        return values;
    }

    private Channel channel(Channel.Semantic semantic, String name, int components, Channel.Type type, BitSet absent) {
        int[] values = new int[components * WEDGES];
        float[] floats = floats(values.length);
        Arrays.setAll(
                values,
                i -> absent.get(i / components)
                        ? 0
                        : type == Channel.Type.UINT8 ? random.nextInt(256) : Float.floatToRawIntBits(floats[i]));
        return new Channel(semantic, name, components, type, values, absent);
    }

    private Mesh mesh(List<Material> materials, List<Texture> textures) {
        int[] wedgeVertices = new int[WEDGES];
        for (int w = 0; w < WEDGES; w++) wedgeVertices[w] = w / 3;
        // faces use either the first wedges, which have everything, or the last ones, which lack some
        int[] faces = new int[3 * 80];
        for (int c = 0; c < faces.length; c++)
            faces[c] = c / 3 % 2 == 0 ? random.nextInt(WEDGES / 2) : WEDGES / 2 + random.nextInt(WEDGES / 2);
        int[] faceMaterials = random.ints(80, -1, materials.size()).toArray();
        BitSet none = new BitSet();
        BitSet half = new BitSet();
        half.set(WEDGES / 2, WEDGES);
        return new MeshBuilder()
                .positions(floats(WEDGES))
                .wedgeVertices(wedgeVertices)
                .faceWedges(faces)
                .faceMaterials(faceMaterials)
                .materials(materials)
                .textures(textures)
                .channels(List.of(
                        channel(Channel.Semantic.NORMAL, "normal", 3, Channel.Type.FLOAT32, none),
                        channel(Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, half),
                        channel(Channel.Semantic.TEXCOORD, "uv1", 2, Channel.Type.FLOAT32, none),
                        channel(Channel.Semantic.COLOUR, "colour", 3, Channel.Type.UINT8, half),
                        channel(Channel.Semantic.COLOUR, "colour1", 4, Channel.Type.FLOAT32, none)))
                .build();
    }

    private static ModelFile roundTrip(Mesh mesh, List<String> notes) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        notes.addAll(GltfWriter.write(mesh, UpAxis.UNKNOWN, "x.glb", name -> out, notes));
        return GltfReader.read("x.glb", out.toByteArray(), ResourceResolver.NONE);
    }

    @Test
    void shouldStandAModelUprightWhoseZAxisPointsUp() throws IOException {
        Mesh mesh = new MeshBuilder()
                .positions(new float[] {1, 2, 3, 4, 5, 6, 7, 9, 8})
                .faceWedges(new int[] {0, 1, 2})
                .build();
        List<String> remarks = new ArrayList<>();
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        GltfWriter.write(mesh, UpAxis.Z, "x.glb", name -> out, remarks);
        assertThat(remarks)
                .containsExactly("The z axis of the model points up, and in glTF y does: a node turns the model.");
        Mesh read = GltfReader.read("x.glb", out.toByteArray(), ResourceResolver.NONE)
                .mesh();
        assertThat(read.positions()).containsExactly(1, 3, -2, 4, 6, -5, 7, 8, -9);
        for (UpAxis same : List.of(UpAxis.Y, UpAxis.UNKNOWN)) {
            ByteArrayOutputStream plain = new ByteArrayOutputStream();
            assertThat(GltfWriter.write(mesh, same, "x.glb", name -> plain, remarks))
                    .isEmpty();
            assertThat(GltfReader.read("x.glb", plain.toByteArray(), ResourceResolver.NONE)
                            .mesh()
                            .positions())
                    .isEqualTo(mesh.positions());
        }
        assertThat(remarks).hasSize(1);
    }

    @Test
    void shouldBringBackEveryBitAndEveryDefinition() throws IOException {
        List<Material> materials = List.of(
                new Material(
                        "gltf",
                        List.of(),
                        List.of(
                                new Material.TextureReference("occlusionTexture", "a.png"),
                                new Material.TextureReference("baseColorTexture", "a.png")),
                        "{\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.10,2E-1,0.3,1.0],\"baseColorTexture\":"
                                + "{\"index\":{\"sampler\":{\"wrapT\":33071},\"source\":1},\"texCoord\":1}},"
                                + "\"occlusionTexture\":{\"strength\":0.50,\"index\":{\"source\":0}},"
                                + "\"alphaMode\":\"MASK\",\"alphaCutoff\":0.3,\"doubleSided\":true}"),
                new Material(
                        "mtl",
                        List.of(
                                new Material.Parameter("Kd", .1f, -0f, 1e-30f),
                                new Material.Parameter("Ka spectral x")),
                        List.of(
                                new Material.TextureReference("map_Kd", "b c.jpg"),
                                new Material.TextureReference("map_Ks", "gone.png"))),
                Material.named("bare"));
        List<Texture> textures = List.of(
                new Texture("a.png", new byte[] {(byte) 0x89, 'P', 'N', 'G'}),
                new Texture("b c.jpg", new byte[] {(byte) 0xFF, (byte) 0xD8, 1, 2, 3}));
        Mesh mesh = mesh(materials, textures);
        List<String> notes = new java.util.ArrayList<>();
        ModelFile again = roundTrip(mesh, notes);
        assertThat(notes)
                .containsExactly(
                        "Materials of another format translated for glTF, their definitions kept in the extras.");
        assertThat(again.notes())
                .containsExactly(Note.dropped(
                                "Textures not found; put the images beside the model under these names and encode it again: gone.png.",
                                1,
                                "gone.png")
                        .asWarning());
        assertThat(MeshComparison.firstDifference(mesh, again.mesh())).isEmpty();
        assertThat(again.mesh().textures()).hasSize(2);
        for (Texture texture : again.mesh().textures()) {
            assertThat(texture.bytes())
                    .isEqualTo(textures.stream()
                            .filter(t -> t.path().equals(texture.path()))
                            .findFirst()
                            .orElseThrow()
                            .bytes());
        }
    }

    @Test
    void shouldSayWhatItCannotHold() throws IOException {
        Mesh mesh = mesh(List.of(), List.of());
        BitSet some = new BitSet();
        some.set(0);
        int[] wide = new int[2 * WEDGES];
        for (int w = 0; w < WEDGES; w++) {
            long bits = Double.doubleToRawLongBits(w + .1);
            wide[2 * w] = (int) bits;
            wide[2 * w + 1] = (int) (bits >>> 32);
        }
        Mesh odd = MeshBuilder.from(mesh)
                .channels(List.of(
                        channel(Channel.Semantic.NORMAL, "normal", 3, Channel.Type.FLOAT32, some),
                        new Channel(Channel.Semantic.CUSTOM, "time", 1, Channel.Type.FLOAT64, wide, null)))
                .faceChannels(
                        List.of(new FaceChannel("smoothing", 1, Channel.Type.INT32, new int[mesh.faces()], List.of())))
                .build();
        List<String> notes = new java.util.ArrayList<>();
        roundTrip(odd, notes);
        assertThat(notes).hasSize(3);
        assertThat(notes.get(0)).isEqualTo("glTF holds these channels in float32 alone, and rounds them: time.");
        assertThat(notes.get(1)).isEqualTo("glTF does not hold these attributes of faces: smoothing.");
        assertThat(notes.get(2)).startsWith("glTF has no mark for absent attributes");
    }

    @Test
    void shouldBringBackTheDuck() throws IOException {
        Path duck = SampleModels.other("Duck.glb");
        ModelFile file = GltfReader.read("Duck.glb", Files.readAllBytes(duck), path -> Optional.empty());
        assertThat(file.format()).isEqualTo(ModelFormat.GLB);
        assertThat(file.notes()).extracting(Note::text).containsExactly("Cameras dropped: camera 0.");
        assertThat(file.mesh().faces()).isEqualTo(4212);
        assertThat(file.mesh().wedges()).isEqualTo(2399);
        assertThat(file.mesh().textures()).hasSize(1);
        List<String> notes = new java.util.ArrayList<>();
        assertThat(MeshComparison.firstDifference(
                        file.mesh(), roundTrip(file.mesh(), notes).mesh()))
                .isEmpty();
        assertThat(notes).isEmpty();
    }

    @Test
    void shouldTranslateOpacityMetalRoughnessAndLightOfMtl() throws IOException {
        byte[] withAlpha = new byte[26];
        System.arraycopy(new byte[] {(byte) 0x89, 'P', 'N', 'G'}, 0, withAlpha, 0, 4);
        withAlpha[25] = 6;
        List<Material> materials = List.of(
                new Material(
                        "chrome",
                        List.of(
                                new Material.Parameter("Kd", 1, .5f, 0),
                                new Material.Parameter("Tr", .25f),
                                new Material.Parameter("Pm", 1),
                                new Material.Parameter("Ns", 250),
                                new Material.Parameter("Ke", 0, .5f, 1)),
                        List.of()),
                new Material(
                        "leaf",
                        List.of(new Material.Parameter("Kd", 0, 0, 0)),
                        List.of(
                                new Material.TextureReference("map_Kd", "leaf.png"),
                                new Material.TextureReference("map_d", "holes.png"))));
        Mesh mesh = mesh(materials, List.of(new Texture("leaf.png", withAlpha)));
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        List<String> remarks = new java.util.ArrayList<>();
        GltfWriter.write(mesh, UpAxis.UNKNOWN, "x.glb", name -> out, remarks);
        byte[] glb = out.toByteArray();
        int length = ByteBuffer.wrap(glb).order(ByteOrder.LITTLE_ENDIAN).getInt(12);
        JsonNode written = new ObjectMapper().readTree(glb, 20, length).path("materials");
        JsonNode chrome = written.get(0);
        assertThat(chrome.path("alphaMode").asText()).isEqualTo("BLEND");
        assertThat(numbers(chrome.path("pbrMetallicRoughness").path("baseColorFactor")))
                .containsExactly(1, .2140411f, 0, .75f);
        assertThat(chrome.path("pbrMetallicRoughness").path("metallicFactor").asDouble())
                .isEqualTo(1);
        assertThat(chrome.path("pbrMetallicRoughness").path("roughnessFactor").asDouble())
                .isEqualTo(.5);
        assertThat(numbers(chrome.path("emissiveFactor"))).containsExactly(0, .2140411f, 1);
        JsonNode leaf = written.get(1);
        assertThat(leaf.path("alphaMode").asText()).isEqualTo("MASK");
        assertThat(numbers(leaf.path("pbrMetallicRoughness").path("baseColorFactor")))
                .containsExactly(1, 1, 1, 1);
        assertThat(remarks).contains("glTF has no such images by themselves, so the extras alone have them: map_d.");
    }

    private static float[] numbers(JsonNode array) {
        float[] numbers = new float[array.size()];
        for (int i = 0; i < numbers.length; i++)
            numbers[i] = Math.round(array.get(i).asDouble() * 1e7) / 1e7f;
        return numbers;
    }
}
