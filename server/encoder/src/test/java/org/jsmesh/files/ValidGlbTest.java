package org.jsmesh.files;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.jsmesh.archive.Provenance;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Channel.Semantic;
import org.jsmesh.mesh.Channel.Type;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.mesh.io.ModelFormat;
import org.jsmesh.mesh.io.ModelFormatException;
import org.jsmesh.test.Requirement;
import org.jsmesh.test.SampleModels;
import org.jsmesh.test.material.MaterialModel;
import org.jsmesh.test.material.MaterialModels;
import org.jsmesh.test.material.MtlModels;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Khronos' validator finds no error in the GLB files that archives are decoded to, but those of the original. */
class ValidGlbTest {
    /** Encoding more takes long; what the archive gives is the same mesh. */
    private static final int MOST_ENCODED_FACES = 3000;

    private static final String VALIDATE = "client/web/src/test/js/support/validate-gltf.js";
    private static final int FACES = 60;

    private final Random random = new Random(7);
    private Path node;

    @TempDir
    private Path folder;

    @BeforeEach
    void findNode() {
        node = Requirement.node();
    }

    @Test
    void shouldFindNoErrorInFilesOfModels() throws Exception {
        for (MaterialModel model : MtlModels.all()) model.write(folder);
        List<Path> models = new ArrayList<>(SampleModels.all());
        for (MaterialModel model : MtlModels.all()) models.add(folder.resolve(model.name() + ".obj"));
        List<Path> written = new ArrayList<>();
        for (Path model : models)
            written.add(write(ModelFiles.read(model).mesh(), UpAxis.UNKNOWN, "model-" + written.size()));
        assertThat(errors(written)).isEmpty();
    }

    @Test
    void shouldFindNoErrorInFilesOfMeshesOfEveryKind() throws Exception {
        Mesh mixed = mixed().build();
        double[] far = new double[9 * FACES];
        for (int i = 0; i < far.length; i++) far[i] = 4.5e6 + random.nextInt(1000) / 8.0;
        Mesh doubles = MeshBuilder.from(mixed).positions(far).build();
        Mesh empty = new MeshBuilder().positions(new float[] {0, 0, 0}).build();
        Mesh flat = new MeshBuilder()
                .positions(new float[] {1, 1, 1, 1, 1, 1, 1, 1, 1})
                .faceWedges(new int[] {0, 1, 2})
                .build();
        List<Path> written = List.of(
                write(mixed, UpAxis.Y, "mixed"),
                write(mixed, UpAxis.Z, "turned"),
                write(doubles, UpAxis.Z, "doubles"),
                write(flat, UpAxis.UNKNOWN, "flat"),
                write(empty, UpAxis.UNKNOWN, "empty"));
        assertThat(errors(written)).isEmpty();
    }

    @Tag("long")
    @Test
    void shouldFindTheErrorsOfTheOriginalAndNoMore() throws Exception {
        List<Path> originals = new ArrayList<>();
        for (MaterialModel model : MaterialModels.all()) {
            model.write(folder);
            originals.add(folder.resolve(model.name() + ".glb"));
        }
        Path field = FieldFolder.place("gltf");
        if (Files.isDirectory(field))
            try (Stream<Path> files = Files.list(field)) {
                files.filter(f -> f.toString().endsWith(".glb")).sorted().forEach(originals::add);
            }
        List<Path> written = new ArrayList<>();
        List<Path> read = new ArrayList<>();
        for (Path original : originals) {
            try {
                Mesh mesh = ModelFiles.read(original).mesh();
                written.add(write(mesh, UpAxis.Y, "again-" + written.size()));
                read.add(original);
            } catch (ModelFormatException e) {
                assertThat(original.getParent()).as(e.getMessage()).isEqualTo(field);
            }
        }
        assertThat(written).hasSizeGreaterThan(20);
        assertNoMoreErrors(read, written);
    }

    /** Images that are no pictures, that have no bytes, and that name a missing file. */
    @Test
    void shouldFindNoMoreErrorsForImagesThatAreNone() throws Exception {
        List<Path> read = new ArrayList<>();
        List<Path> written = new ArrayList<>();
        for (String image : List.of(
                "\"uri\":\"data:image/svg+xml,%3Csvg%3E\"",
                "\"mimeType\":\"image/png\",\"uri\":\"data:image/png;base64,AAAA\"",
                "\"uri\":\"data:image/gif;base64,R0lGODlh\"",
                "\"name\":\"x\"",
                "\"uri\":\"gone.png\"")) {
            Path file = folder.resolve("image-" + read.size() + ".gltf");
            Files.writeString(file, triangle("{" + image + "}"));
            written.add(write(ModelFiles.read(file).mesh(), UpAxis.Y, "again-" + read.size()));
            read.add(file);
        }
        Map<String, Map<String, Integer>> errors = errors(written);
        for (int i = 0; i < 3; i++)
            assertThat(errors.getOrDefault("again-" + i + ".glb", Map.of()))
                    .doesNotContainKeys("image", "TEXTURE_INVALID_IMAGE_MIME_TYPE");
        assertNoMoreErrors(read, written);
    }

    private static String triangle(String image) {
        ByteBuffer positions = ByteBuffer.allocate(36).order(ByteOrder.LITTLE_ENDIAN);
        positions.putFloat(12, 1).putFloat(28, 1);
        return "{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
                + "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"material\":0}]}],\"materials\":"
                + "[{\"emissiveTexture\":{\"index\":0}}],\"textures\":[{\"source\":0}],\"images\":[" + image
                + "],\"buffers\":[{\"byteLength\":36,\"uri\":\"data:application/octet-stream;base64,"
                + Base64.getEncoder().encodeToString(positions.array())
                + "\"}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],\"accessors\":[{\"bufferView\":0,"
                + "\"componentType\":5126,\"type\":\"VEC3\",\"count\":3,\"min\":[0,0,0],\"max\":[1,1,0]}]}";
    }

    /** Of each kind there are as many errors as in the original, or fewer. */
    private void assertNoMoreErrors(List<Path> originals, List<Path> written) throws Exception {
        Map<String, Map<String, Integer>> before = errors(originals);
        Map<String, Map<String, Integer>> after = errors(written);
        for (int i = 0; i < written.size(); i++) {
            String name = originals.get(i).getFileName().toString();
            Map<String, Integer> known = before.getOrDefault(name, Map.of());
            after.getOrDefault(written.get(i).getFileName().toString(), Map.of())
                    .forEach((kind, count) -> assertThat(count)
                            .as(name + " " + kind + " " + known)
                            .isLessThanOrEqualTo(known.getOrDefault(kind, 0)));
        }
    }

    @Test
    void shouldSeeErrors() throws Exception {
        Path file = folder.resolve("bad.glb");
        Files.writeString(file, "{\"asset\":{\"version\":\"2.0\"},\"nodes\":[]}");
        assertThat(errors(List.of(file)).get("bad.glb")).containsExactly(Map.entry("EMPTY_ENTITY", 1));
    }

    /** Attributes of every type, each absent on faces of its own; materials with and without images; objects. */
    private MeshBuilder mixed() {
        int[] faces = new int[3 * FACES];
        for (int i = 0; i < faces.length; i++) faces[i] = i;
        float[] positions = new float[3 * faces.length];
        for (int i = 0; i < positions.length; i++) positions[i] = (float) random.nextGaussian();
        List<Channel> channels = new ArrayList<>();
        channels.add(channel(Semantic.NORMAL, "normal", 3, Type.FLOAT32));
        channels.add(channel(Semantic.NORMAL, "other normal", 3, Type.INT16));
        for (Type type : Type.values()) {
            channels.add(channel(Semantic.TEXCOORD, "uv " + type, 2, type));
            channels.add(channel(Semantic.COLOUR, "colour " + type, 3 + type.ordinal() % 2, type));
            channels.add(channel(Semantic.CUSTOM, "custom " + type, 1 + type.ordinal() % 4, type));
        }
        channels.add(channel(Semantic.CUSTOM, "JOINTS_0", 4, Type.UINT8));
        int[] objects = random.ints(FACES, 0, 3).toArray();
        return new MeshBuilder()
                .positions(positions)
                .faceWedges(faces)
                .channels(channels)
                .materials(List.of(
                        Material.named("bare"),
                        new Material("red", List.of(new Material.Parameter("Kd", 1, 0, 0)), List.of()),
                        new Material("gltf", List.of(), List.of(), "{\"extensions\":{\"KHR_materials_unlit\":{}}}")))
                .faceMaterials(random.ints(FACES, -1, 3).toArray())
                .faceChannels(
                        List.of(new FaceChannel(FaceChannel.OBJECT, 1, Type.INT32, objects, List.of("", "a", "b"))));
    }

    private Channel channel(Semantic semantic, String name, int components, Type type) {
        BitSet absent = new BitSet();
        for (int f = 0; f < FACES; f++) if (random.nextInt(4) == 0) absent.set(3 * f, 3 * f + 3);
        if (random.nextBoolean()) absent.flip(random.nextInt(3 * FACES));
        int words = components * type.words();
        int[] values = new int[3 * FACES * words];
        for (int i = 0; i < values.length; i++) if (!absent.get(i / words)) values[i] = value(type, i);
        return new Channel(semantic, name, components, type, values, absent);
    }

    private int value(Type type, int at) {
        return switch (type) {
            case UINT8 -> random.nextInt(256);
            case INT8 -> random.nextInt(256) - 128;
            case UINT16 -> random.nextInt(65536);
            case INT16 -> random.nextInt(65536) - 32768;
            case FLOAT32 -> Float.floatToRawIntBits((float) random.nextGaussian());
            case FLOAT64 ->
                at % 2 == 0 ? random.nextInt() : (int) (Double.doubleToRawLongBits(random.nextGaussian()) >>> 32);
            default -> random.nextInt();
        };
    }

    private Path write(Mesh mesh, UpAxis up, String name) throws IOException {
        Path file = folder.resolve(name + ".glb");
        ModelFiles.write(decoded(mesh), up, file, ModelFormat.GLB);
        return file;
    }

    /** The mesh that an archive of it gives. */
    private static Mesh decoded(Mesh mesh) throws IOException {
        if (mesh.faces() == 0 || mesh.faces() > MOST_ENCODED_FACES) return mesh;
        EncodedArchive archive = new MeshEncoder(EncoderSettings.defaults())
                .encode(mesh, Provenance.NONE, List.of(), ProgressListener.NONE);
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(archive.bytes(), 0, archive.bytes().length);
        return decoder.mesh();
    }

    /**
     * The numbers of errors of each code by the name of their file. An image that is not there is one error, whether
     * the file names another file for it, or nothing.
     */
    private Map<String, Map<String, Integer>> errors(List<Path> files) throws Exception {
        Path list = folder.resolve("list.txt");
        Files.write(list, files.stream().map(Path::toString).toList());
        Path output = folder.resolve("errors.json");
        Path problems = folder.resolve("problems.txt");
        Process validator = new ProcessBuilder(
                        node.toString(),
                        SampleModels.project().resolve(VALIDATE).toString(),
                        list.toString())
                .redirectOutput(output.toFile())
                .redirectError(problems.toFile())
                .start();
        assertThat(validator.waitFor()).as(Files.readString(problems)).isZero();
        Map<String, Map<String, Integer>> errors = new TreeMap<>();
        for (Map.Entry<String, JsonNode> file :
                new ObjectMapper().readTree(output.toFile()).properties()) {
            Map<String, Integer> codes = new TreeMap<>();
            for (JsonNode error : file.getValue()) {
                String[] words = error.asText().split(" ");
                codes.merge(words[1].startsWith("/images/") ? "image" : words[0], 1, Integer::sum);
            }
            errors.put(file.getKey(), codes);
        }
        return errors;
    }
}
