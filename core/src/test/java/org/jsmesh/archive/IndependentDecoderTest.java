package org.jsmesh.archive;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.TimeUnit;
import java.util.function.DoubleBinaryOperator;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.encode.Quality;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.Texture;
import org.jsmesh.test.RandomMeshes;
import org.jsmesh.test.Requirement;
import org.jsmesh.test.SampleModels;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * What docs/format.md says is what archives are: a decoder that was written along it, in another language, finds the
 * mesh that was encoded.
 */
@Tag("slow")
class IndependentDecoderTest {
    private static final int SEEDS = 4;

    @TempDir
    Path folder;

    private final Map<Path, String> expected = new LinkedHashMap<>();

    @Test
    void shouldFindMeshesOfEveryKind() throws Exception {
        Path python = Requirement.python();
        for (RandomMeshes kind : RandomMeshes.values()) {
            for (int seed = 21; seed < 21 + SEEDS; seed++) add(kind.mesh(seed), Quality.DEFAULT);
        }
        assertThat(decode(python)).isEqualTo(lines());
    }

    @Test
    void shouldFindMeshesOfEveryQuality() throws Exception {
        Path python = Requirement.python();
        for (Quality quality : Quality.values()) {
            for (RandomMeshes kind : RandomMeshes.values()) add(kind.mesh(1), quality);
        }
        assertThat(decode(python)).isEqualTo(lines());
    }

    @Test
    void shouldFindVerticesThatMoveWithoutMorePrecision() throws Exception {
        Path python = Requirement.python();
        DoubleBinaryOperator roof = (x, y) -> Math.abs(x - .5) + Math.abs(y - .4);
        DoubleBinaryOperator hill = (x, y) -> .3 * Math.sin(3 * x) + .1 * y * y;
        for (Quality quality : Quality.values()) {
            add(field(roof), quality);
            add(field(hill), quality);
        }
        assertThat(decode(python)).isEqualTo(lines());
    }

    /** A height field of decimals. Its coarse levels are so close to it that they soon have all bits that are seen. */
    private static Mesh field(DoubleBinaryOperator height) {
        int n = 40;
        float[] positions = new float[3 * n * n];
        int[] faces = new int[6 * (n - 1) * (n - 1)];
        int f = 0;
        for (int v = 0; v < n * n; v++) {
            int i = v / n;
            int j = v % n;
            double x = i / (n - 1.0);
            double y = j / (n - 1.0);
            double[] position = {x, y, height.applyAsDouble(x, y)};
            for (int a = 0; a < 3; a++) positions[3 * v + a] = Math.round(1e5 * position[a]) / 1e5f;
            if (i == n - 1 || j == n - 1) continue;
            for (int corner : new int[] {v, v + 1, v + n, v + 1, v + n + 1, v + n}) faces[f++] = corner;
        }
        return new MeshBuilder().positions(positions).faceWedges(faces).build();
    }

    @Test
    void shouldFindWhatFloat32DoesNotHold() throws Exception {
        Path python = Requirement.python();
        for (ExactArchiveTest.Numbers numbers : ExactArchiveTest.Numbers.values()) {
            for (RandomMeshes kind : new RandomMeshes[] {RandomMeshes.SPHERE, RandomMeshes.GRID_WITH_HOLES})
                add(ExactArchiveTest.moved(kind.mesh(5), numbers.of), Quality.DEFAULT);
        }
        for (RandomMeshes kind : RandomMeshes.values())
            add(ExactArchiveTest.withFaceChannels(kind.mesh(2)), Quality.DEFAULT);
        assertThat(decode(python)).isEqualTo(lines());
    }

    @Tag("long")
    @Test
    void shouldFindAttributesOfEveryType() throws Exception {
        Path python = Requirement.python();
        Mesh bare = RandomMeshes.SPHERE.mesh(7);
        for (Channel.Semantic semantic : Channel.Semantic.values()) {
            for (Channel.Type type : Channel.Type.values()) {
                add(AttributedMeshes.with(bare, smooth(bare, semantic, type)), Quality.DEFAULT);
                add(AttributedMeshes.with(bare, rough(bare, semantic, type)), Quality.DEFAULT);
            }
        }
        assertThat(decode(python)).isEqualTo(lines());
    }

    /** A channel whose values follow the positions. */
    private static Channel smooth(Mesh mesh, Channel.Semantic semantic, Channel.Type type) {
        int n = 3 * mesh.wedges();
        int[] values = new int[n * type.words()];
        for (int i = 0; i < n; i++) {
            float x = mesh.positions()[3 * mesh.wedgeVertices()[i / 3] + i % 3];
            if (type == Channel.Type.FLOAT32) values[i] = Float.floatToRawIntBits((float) Math.sin(x));
            else if (type == Channel.Type.FLOAT64) putDouble(values, i, Math.sin(x));
            else values[i] = (int) (60 + 30 * x);
        }
        return new Channel(semantic, "smooth", 3, type, values, null);
    }

    /** A channel of random values, some of them absent. */
    private static Channel rough(Mesh mesh, Channel.Semantic semantic, Channel.Type type) {
        Random random = new Random(3);
        int n = 2 * mesh.wedges();
        int[] values = new int[n * type.words()];
        BitSet absent = new BitSet();
        for (int i = 0; i < n; i++) {
            if (i / 2 % 9 == 4) absent.set(i / 2);
            else ExactArchiveTest.put(values, i, type, random);
        }
        return new Channel(semantic, "rough", 2, type, values, absent);
    }

    private static void putDouble(int[] values, int i, double x) {
        long bits = Double.doubleToRawLongBits(x);
        values[2 * i] = (int) bits;
        values[2 * i + 1] = (int) (bits >>> 32);
    }

    @Test
    void shouldFindImagesAndPassNotesBy() throws Exception {
        Path python = Requirement.python();
        byte[] wood = new byte[70_000];
        new Random(4).nextBytes(wood);
        Mesh mesh = MeshBuilder.from(RandomMeshes.SPHERE.mesh(4))
                .textures(List.of(new Texture("Größe/wood.png", wood), new Texture("stone.png", new byte[] {1, 2})))
                .build();
        Note dropped = Note.dropped("3 group names not kept.", 3, "wheel");
        Note moved = Note.changed("24 positions rounded.", 24, "vertex 0").asWarning();
        add(mesh, Quality.DEFAULT, new Provenance("OBJ", List.of(dropped, moved)));
        assertThat(decode(python)).isEqualTo(lines());
    }

    private void add(Mesh mesh, Quality quality) throws Exception {
        add(mesh, quality, Provenance.NONE);
    }

    private void add(Mesh mesh, Quality quality, Provenance from) throws Exception {
        EncoderSettings settings =
                EncoderSettings.defaults().withBaseFaces(4).withQuality(quality).withKeepOrder(true);
        Path file = folder.resolve(expected.size() + ".jsm");
        EncodedArchive archive = new MeshEncoder(settings, ForkJoinPool.commonPool())
                .encode(mesh, from, List.of(), ProgressListener.NONE);
        Files.write(file, archive.bytes());
        expected.put(file, MeshIdentity.sha256(mesh) + " " + archive.header().modelSha256());
    }

    private String lines() {
        StringBuilder lines = new StringBuilder();
        expected.forEach(
                (file, hash) -> lines.append(hash).append(' ').append(file).append('\n'));
        return lines.toString();
    }

    /** What the decoder prints: a line for each file. */
    private String decode(Path python) throws Exception {
        List<String> command = new ArrayList<>();
        command.add(python.toString());
        command.add("-B"); // leaves no compiled files beside the sources
        command.add(SampleModels.project()
                .resolve("core/src/test/python/jsm_decode.py")
                .toString());
        for (Path file : expected.keySet()) command.add(file.toString());
        Path out = folder.resolve("out.txt");
        Process process = new ProcessBuilder(command)
                .redirectErrorStream(true)
                .redirectOutput(out.toFile())
                .start();
        try {
            assertThat(process.waitFor(5, TimeUnit.MINUTES))
                    .as("the decoder ends")
                    .isTrue();
        } finally {
            process.destroyForcibly();
        }
        return Files.readString(out, StandardCharsets.UTF_8);
    }
}
