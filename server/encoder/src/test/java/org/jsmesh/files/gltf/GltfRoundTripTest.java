package org.jsmesh.files.gltf;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshComparison;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.Texture;
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
        notes.addAll(GltfWriter.write(mesh, "x.glb", name -> out, notes));
        return GltfReader.read("x.glb", out.toByteArray(), ResourceResolver.NONE);
    }

    @Test
    void shouldBringBackEveryBitAndEveryDefinition() throws IOException {
        List<Material> materials = List.of(
                new Material(
                        "gltf",
                        List.of(
                                new Material.Parameter("baseColorFactor", .1f, .2f, .3f, 1),
                                new Material.Parameter("metallicFactor", 0),
                                new Material.Parameter("roughnessFactor", .7f),
                                new Material.Parameter("emissiveFactor", 0, 0, 1),
                                new Material.Parameter("alphaMode MASK"),
                                new Material.Parameter("alphaCutoff", .3f),
                                new Material.Parameter("doubleSided", 1),
                                new Material.Parameter("baseColorTexture.texCoord", 1),
                                new Material.Parameter("occlusionTexture.strength", .5f)),
                        List.of(
                                new Material.TextureReference("baseColorTexture", "a.png"),
                                new Material.TextureReference("occlusionTexture", "a.png"))),
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
                .containsExactly(Note.dropped("Textures not found, their references kept: gone.png.", 1, "gone.png"));
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
        Mesh odd = MeshBuilder.from(mesh)
                .channels(List.of(
                        channel(Channel.Semantic.CUSTOM, "temperature", 1, Channel.Type.FLOAT32, new BitSet()),
                        channel(Channel.Semantic.TEXCOORD, "uvw", 3, Channel.Type.FLOAT32, new BitSet()),
                        channel(Channel.Semantic.NORMAL, "normal", 3, Channel.Type.FLOAT32, some)))
                .build();
        List<String> notes = new java.util.ArrayList<>();
        roundTrip(odd, notes);
        assertThat(notes).hasSize(2);
        assertThat(notes.get(0)).isEqualTo("glTF does not hold these channels: temperature, uvw.");
        assertThat(notes.get(1)).startsWith("glTF has no mark for absent attributes");
    }

    @Test
    void shouldBringBackTheDuck() throws IOException {
        Path duck = SampleModels.other("Duck.glb");
        ModelFile file = GltfReader.read("Duck.glb", Files.readAllBytes(duck), path -> Optional.empty());
        assertThat(file.format()).isEqualTo(ModelFormat.GLB);
        assertThat(file.notes()).isEmpty();
        assertThat(file.mesh().faces()).isEqualTo(4212);
        assertThat(file.mesh().wedges()).isEqualTo(2399);
        assertThat(file.mesh().textures()).hasSize(1);
        List<String> notes = new java.util.ArrayList<>();
        assertThat(MeshComparison.firstDifference(
                        file.mesh(), roundTrip(file.mesh(), notes).mesh()))
                .isEmpty();
        assertThat(notes).isEmpty();
    }
}
