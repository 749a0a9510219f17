package org.jsmesh.memory;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.zip.GZIPOutputStream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.assertj.core.data.Percentage;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.Explanation;
import org.jsmesh.files.ModelEncoding;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.io.ModelFormat;
import org.jsmesh.test.SampleModels;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class MemoryEstimateTest {
    private static final EncoderSettings SETTINGS = EncoderSettings.defaults();
    private static final int FACES = 2 * 140 * 140;

    @TempDir
    private Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"octopus.ply", "amphora.obj", "planetary-gear.obj"})
    void shouldCountTheFacesOfTheSamples(String name) throws IOException {
        Path file = SampleModels.project().resolve("models").resolve(name);
        Mesh mesh = ModelFiles.read(file).mesh();
        MemoryEstimate estimate = MemoryEstimate.of(file, SETTINGS);
        assertThat(estimate.faces()).isCloseTo(mesh.faces(), Percentage.withPercentage(3));
        assertThat(estimate.channels()).isPositive();
        assertThat(estimate.leastBytes()).isLessThan(estimate.bytes());
        assertThat(fromStart(file).faces()).isBetween(mesh.faces() / 2L, mesh.faces() * 5L / 2);
    }

    @ParameterizedTest
    @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = "THREE_MF")
    void shouldCountTheFacesOfEveryFormat(ModelFormat format) throws IOException {
        Path file = written(format);
        assertThat(MemoryEstimate.of(file, SETTINGS).faces()).isCloseTo(FACES, Percentage.withPercentage(3));
        assertThat(fromStart(file).faces()).isBetween(FACES / 2L, FACES * 5L / 2);
    }

    @ParameterizedTest
    @EnumSource(names = {"PLY", "OBJ", "STL", "GLB"})
    void shouldLookIntoWhatIsPacked(ModelFormat format) throws IOException {
        byte[] model = Files.readAllBytes(written(format));
        String name = "hills." + format.extension();
        Path gzip = folder.resolve(name + ".gz");
        try (GZIPOutputStream out = new GZIPOutputStream(Files.newOutputStream(gzip))) {
            out.write(model);
        }
        Path zip = folder.resolve("hills.zip");
        try (ZipOutputStream out = new ZipOutputStream(Files.newOutputStream(zip))) {
            out.putNextEntry(new ZipEntry("readme.txt"));
            out.putNextEntry(new ZipEntry("inside/" + name));
            out.write(model);
        }
        for (Path packed : List.of(gzip, zip)) {
            MemoryEstimate estimate = MemoryEstimate.of(packed, SETTINGS);
            assertThat(estimate.faces()).as(packed.toString()).isBetween(FACES / 2L, FACES * 5L / 2);
        }
    }

    @Test
    void shouldKnowThatSeparateTrianglesTakeMore() throws IOException {
        Path surface = written(ModelFormat.STL);
        byte[] apart = Files.readAllBytes(surface);
        for (int at = 84; at < apart.length; at += 50) // every corner by another lowest bit
        for (int c = 0; c < 3; c++) apart[at + 12 + 12 * c] += (byte) (at / 50 * 3 + c);
        Path soup = Files.write(folder.resolve("soup.stl"), apart);
        double usual = MemoryEstimate.of(surface, SETTINGS).bytes();
        assertThat((double) MemoryEstimate.of(soup, SETTINGS).bytes()).isBetween(1.4 * usual, 1.7 * usual);
        byte[] pairs = Files.readAllBytes(surface);
        for (int at = 84; at < pairs.length; at += 50) // two triangles share an edge, and no more
        for (int c = 0; c < 3; c++) pairs[at + 12 + 12 * c] += (byte) ((at - 84) / 100);
        Path inPairs = Files.write(folder.resolve("pairs.stl"), pairs);
        assertThat(MemoryEstimate.of(inPairs, SETTINGS).bytes())
                .isEqualTo(MemoryEstimate.of(soup, SETTINGS).bytes());
    }

    @Test
    void shouldAskForFewPartsWhereEachTakesARequest() throws IOException {
        byte[] model = Files.readAllBytes(written(ModelFormat.OBJ));
        assertThat(model.length).isGreaterThan(Sampled.SAMPLES * 4096);
        int[] reads = {0};
        ByteRanges far = new ByteRanges() {
            @Override
            public byte[] read(long from, int bytes) {
                reads[0]++;
                return Arrays.copyOfRange(model, (int) from, (int) from + bytes);
            }

            @Override
            public int samples() {
                return 4;
            }
        };
        MemoryEstimate estimate = MemoryEstimate.of("hills.obj", model.length, far, SETTINGS);
        assertThat(estimate.faces()).isBetween(FACES / 2L, FACES * 2L);
        assertThat(reads[0]).isLessThanOrEqualTo(5); // the first of them is at hand by then
    }

    @Test
    void shouldNotBelieveClaims() {
        String header = "ply\nformat binary_little_endian 1.0\nelement vertex 2000000000\nproperty float x\n"
                + "property float y\nproperty float z\nelement face 2000000000\n"
                + "property list uchar int vertex_indices\nend_header\n";
        MemoryEstimate estimate =
                MemoryEstimate.of("claims.ply", 1000, header.getBytes(StandardCharsets.UTF_8), SETTINGS);
        assertThat(estimate.leastBytes()).isZero();
        assertThat(estimate.faces()).isLessThan(1000);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"", "x", "ply", "glTF", "PK\u0003\u0004", "\u001f\u008b", "solid", "OFF", "OFF\n1 2 3", "{"})
    void shouldTakeAnythingForAModel(String content) {
        for (String name : List.of("a.ply", "a.glb", "a.gltf", "a.stl", "a.obj", "a", "a.zip", "a.obj.gz", "a.3mf")) {
            byte[] bytes = content.getBytes(StandardCharsets.ISO_8859_1);
            MemoryEstimate small = MemoryEstimate.of(name, bytes.length, bytes, SETTINGS);
            assertThat(small.faces()).isLessThan(50);
            assertThat(MemoryEstimate.of(name, 1L << 40, bytes, SETTINGS).bytes())
                    .isGreaterThan(1 << 20);
        }
    }

    @Test
    void shouldFitTheHeapThatFacesAreFor() {
        long heap = 2L << 30;
        long faces = MemoryEstimate.facesFor(heap);
        byte[] start = new byte[84];
        MemoryEstimate plain = MemoryEstimate.of("a.stl", 84 + 50 * faces, start, SETTINGS);
        assertThat(plain.faces()).isEqualTo(faces);
        assertThat(plain.bytes()).isBetween(heap / 2, heap);
    }

    /** A file with holes, which nobody can read within the time of a test. */
    @Test
    void shouldBeRefusedBeforeItIsRead() throws IOException {
        Path huge = folder.resolve("huge.stl");
        long faces = Integer.toUnsignedLong(-1);
        try (RandomAccessFile file = new RandomAccessFile(huge.toFile(), "rw")) {
            file.seek(80);
            file.writeInt(-1);
            file.setLength(84 + 50 * faces);
        }
        ModelEncoding encoding = new ModelEncoding(SETTINGS);
        assertThatThrownBy(() -> encoding.encode(huge, ProgressListener.NONE))
                .isInstanceOfSatisfying(HeapShortageException.class, e -> {
                    assertThat(e.needBytes()).isGreaterThan(e.limitBytes());
                    assertThat(Explanation.of(huge, e).toString())
                            .contains(
                                    "huge.stl: needs about ",
                                    " GiB of heap memory, and the limit is ",
                                    "--max-heap ",
                                    "-Xmx");
                    assertThat(Explanation.of("the model", e, Explanation.Audience.SENDER)
                                    .remedy())
                            .isEqualTo("send a smaller model");
                });
        Files.delete(huge);
    }

    @Test
    void shouldWarnAbove85Percent() {
        MemoryEstimate need = new MemoryEstimate(1, 0, 850 << 20, 1);
        assertThat(HeapShortageException.warning(need, 1000 << 20)).isNull();
        assertThat(HeapShortageException.warning(need, 999 << 20))
                .isEqualTo(
                        "may need 850 MiB of heap memory, and the limit is 999 MiB. Give Java more: --max-heap 1g of 'jsm "
                                + "encode', or -Xmx1g if it fails.");
    }

    private static MemoryEstimate fromStart(Path file) throws IOException {
        byte[] all = Files.readAllBytes(file);
        byte[] start = Arrays.copyOf(all, Math.min(all.length, MemoryEstimate.START_BYTES));
        return MemoryEstimate.of(file.getFileName().toString(), all.length, start, SETTINGS);
    }

    private Path written(ModelFormat format) throws IOException {
        Path file = folder.resolve("hills." + format.extension());
        ModelFiles.write(hills(141), file, format);
        return file;
    }

    private static Mesh hills(int side) {
        float[] p = new float[3 * side * side];
        int[] faces = new int[6 * (side - 1) * (side - 1)];
        int n = 0;
        for (int v = 0; v < side * side; v++) {
            p[3 * v] = .37f * (v % side);
            p[3 * v + 1] = .41f * (v / side);
            p[3 * v + 2] = (float) Math.sin(.1 * v);
            if (v % side == side - 1 || v / side == side - 1) continue;
            for (int corner : new int[] {v, v + 1, v + side, v + 1, v + side + 1, v + side}) faces[n++] = corner;
        }
        return new MeshBuilder().positions(p).faceWedges(faces).build();
    }
}
