package org.jsmesh.archive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.BitSet;
import java.util.List;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshComparison;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Archives of what float32 and 8 bits do not hold. */
class ExactArchiveTest {
    private static final Mesh SPHERE = RandomMeshes.SPHERE.mesh(7);

    /** Numbers that positions of a model in metres may be, given those of a model of a few units. */
    enum Numbers {
        MILLIMETRES_FAR_AWAY(x -> decimal(x * 100 + 450_000, 1e3)),
        MICROMETRES_FAR_AWAY(x -> decimal(x * 100 - 5_411_000, 1e6)),
        NANOMETRES(x -> decimal(x, 1e9)),
        WHOLE_NUMBERS(x -> Math.rint(x * 1e9)),
        DOUBLES(x -> x * Math.PI),
        DOUBLES_FAR_AWAY(x -> x * Math.PI + 5_411_000),
        DOUBLES_OF_FLOATS(x -> (float) (x * 3) + 450_000.1),
        TINY_DOUBLES(x -> x * 1e-300),
        LARGE_DOUBLES(x -> x * 1e36 * Math.PI),
        DECIMALS_AND_SOME_DOUBLES(x -> x > 0 && x < .05 ? x * Math.E : decimal(x + 1000, 1e5)),
        MINUS_ZEROS(x -> x < .3 ? -0.0 : decimal(x * Math.PI, 1e8));

        final DoubleUnaryOperator of;

        Numbers(DoubleUnaryOperator of) {
            this.of = of;
        }
    }

    private static double decimal(double x, double scale) {
        return Math.rint(x * scale) / scale;
    }

    static Mesh moved(Mesh mesh, DoubleUnaryOperator by) {
        double[] positions = new double[mesh.positions().length];
        for (int i = 0; i < positions.length; i++) positions[i] = by.applyAsDouble(mesh.positions()[i]);
        return MeshBuilder.from(mesh).positions(positions).build();
    }

    @ParameterizedTest
    @EnumSource
    void shouldGiveBackDoubles(Numbers numbers) throws Exception {
        for (RandomMeshes kind : new RandomMeshes[] {RandomMeshes.SPHERE, RandomMeshes.GRID_WITH_HOLES}) {
            Mesh mesh = moved(kind.mesh(5), numbers.of);
            assertThat(mesh.isDouble()).isTrue();
            byte[] bytes = TestArchives.encodeFar(mesh).bytes();
            ArchiveDecoder decoder = TestArchives.decode(bytes, bytes.length);
            assertThat(MeshComparison.firstDifference(mesh, decoder.mesh())).isEmpty();
            assertThat(MeshIdentity.sha256(decoder.mesh()))
                    .isEqualTo(decoder.header().meshSha256())
                    .isEqualTo(MeshIdentity.sha256(mesh));
        }
    }

    @Test
    void shouldCostAsMuchAsTheSameScanAtTheOrigin() throws Exception {
        Mesh scan = moved(RandomMeshes.SPHERE.mesh(40), x -> Math.rint(x * 20_000) / 1000);
        Mesh near = MeshBuilder.from(scan).positions(floats(scan)).build();
        Mesh far = moved(near, x -> Math.rint((x + 450_000) * 1000) / 1000);
        assertThat(near.isDouble()).isFalse();
        int atOrigin = TestArchives.encode(near).bytes().length;
        assertThat(TestArchives.encode(far).bytes().length).isLessThan(atOrigin + 24);
    }

    private static float[] floats(Mesh mesh) {
        float[] floats = new float[3 * mesh.vertices()];
        for (int i = 0; i < floats.length; i++) floats[i] = (float) mesh.coordinate(i / 3, i % 3);
        return floats;
    }

    @Test
    void shouldShowOffsetsFromTheOriginFromTheBaseOn() throws Exception {
        Mesh mesh = moved(SPHERE, x -> decimal(x * 100 + 450_000, 1e6));
        byte[] bytes = TestArchives.encodeFar(mesh).bytes();
        ArchiveDecoder decoder = new ArchiveDecoder();
        for (int at = 0; at < bytes.length; at++) {
            int before = decoder.batches();
            decoder.feed(bytes, at, 1);
            if (decoder.batches() == before) continue;
            Mesh shown = decoder.mesh();
            assertThat(shown.origin()).isEqualTo(decoder.opening().origin());
            for (int a = 0; a < 3; a++) {
                assertThat(shown.origin()[a]).isCloseTo(450_000, within(200.0));
                assertThat(shown.coordinate(0, a)).isCloseTo(450_000, within(400.0));
            }
            assertThat(shown.exactPositions() != null).isEqualTo(decoder.isComplete());
        }
        assertThat(decoder.isComplete()).isTrue();
    }

    @Test
    void shouldKeepEveryTypeOfAttribute() throws Exception {
        Random random = new Random(8);
        for (Channel.Type type : Channel.Type.values()) {
            int n = SPHERE.wedges();
            int[] values = new int[2 * n * type.words()];
            BitSet absent = new BitSet();
            for (int i = 0; i < 2 * n; i++) {
                if (i / 2 % 9 == 4) absent.set(i / 2);
                else put(values, i, type, random);
            }
            Channel channel = new Channel(Channel.Semantic.CUSTOM, "measured", 2, type, values, absent);
            Mesh mesh = AttributedMeshes.with(SPHERE, channel);
            Mesh decoded = whole(mesh);
            assertThat(decoded.channels().get(0).type()).isEqualTo(type);
            assertThat(MeshComparison.firstDifference(mesh, decoded)).isEmpty();
        }
    }

    static void put(int[] values, int i, Channel.Type type, Random random) {
        int bits = random.nextInt();
        switch (type) {
            case FLOAT32 -> values[i] = Float.floatToRawIntBits((float) random.nextGaussian());
            case FLOAT64 -> {
                double x = i % 5 == 0 ? 0 : i % 7 == 0 ? 1e300 * random.nextGaussian() : random.nextGaussian();
                long all = Double.doubleToRawLongBits(x);
                values[2 * i] = (int) all;
                values[2 * i + 1] = (int) (all >>> 32);
            }
            case UINT8 -> values[i] = bits & 255;
            case INT8 -> values[i] = (byte) bits;
            case INT16 -> values[i] = (short) bits;
            case UINT16 -> values[i] = bits & 65535;
            case INT32, UINT32 -> values[i] = i % 3 == 0 ? bits : bits & 7;
        }
    }

    @Test
    void shouldShowColoursOf16BitsAsPartsOfOne() throws Exception {
        int[] rgb = new int[3 * SPHERE.wedges()];
        for (int i = 0; i < rgb.length; i++) rgb[i] = i * 977 % 65536;
        Mesh mesh = AttributedMeshes.with(
                SPHERE, new Channel(Channel.Semantic.COLOUR, "colour", 3, Channel.Type.UINT16, rgb, null));
        byte[] bytes = TestArchives.encodeFar(mesh).bytes();
        ArchiveDecoder decoder = TestArchives.decode(bytes, bytes.length);
        assertThat(MeshComparison.firstDifference(mesh, decoder.mesh())).isEmpty();
        int base = (int) decoder.header().batches().end(0);
        Channel shown = TestArchives.decode(bytes, base).mesh().channels().get(0);
        for (int i = 0; i < 3 * shown.wedges(); i++)
            assertThat(shown.number(i / 3, i % 3)).isBetween(0f, 1f);
        assertThat(decoder.opening().channels().get(0).type()).isEqualTo(Channel.Type.UINT16);
    }

    @Test
    void shouldKeepWholeNumbersAsNormals() throws Exception {
        int[] normals = new int[3 * SPHERE.wedges()];
        for (int i = 0; i < normals.length; i++) normals[i] = (int) (127 * SPHERE.positions()[i] / 3);
        Mesh mesh = AttributedMeshes.with(
                SPHERE, new Channel(Channel.Semantic.NORMAL, "normal", 3, Channel.Type.INT8, normals, null));
        assertThat(MeshComparison.firstDifference(mesh, whole(mesh))).isEmpty();
    }

    static Mesh withFaceChannels(Mesh mesh) {
        int n = mesh.faces();
        int[] group = new int[n];
        int[] smoothing = new int[n];
        int[] quality = new int[2 * n];
        int[] word = new int[n];
        for (int f = 0; f < n; f++) {
            group[f] = mesh.positions()[3 * mesh.vertex(f, 0)] > 0 ? 1 : 0;
            smoothing[f] = f % 50 == 0 ? 1 << 31 : 4;
            word[f] = f * 31 & 0x7fff;
            long bits = Double.doubleToRawLongBits(f / 10.0);
            quality[2 * f] = (int) bits;
            quality[2 * f + 1] = (int) (bits >>> 32);
        }
        return MeshBuilder.from(mesh)
                .faceChannels(List.of(
                        new FaceChannel(FaceChannel.GROUP, 1, Channel.Type.INT32, group, List.of("wheel left", "车")),
                        new FaceChannel(FaceChannel.SMOOTHING, 1, Channel.Type.UINT32, smoothing, List.of()),
                        new FaceChannel("quality", 1, Channel.Type.FLOAT64, quality, List.of()),
                        new FaceChannel("attribute", 1, Channel.Type.UINT16, word, List.of())))
                .build();
    }

    @ParameterizedTest
    @EnumSource
    void shouldKeepAttributesOfFaces(RandomMeshes kind) throws Exception {
        Mesh mesh = withFaceChannels(kind.mesh(2));
        byte[] bytes = TestArchives.encodeFar(mesh).bytes();
        ArchiveDecoder decoder = TestArchives.decode(bytes, bytes.length);
        assertThat(MeshComparison.firstDifference(mesh, decoder.mesh())).isEmpty();
        assertThat(decoder.header().faceChannels())
                .extracting(FaceChannelInfo::name)
                .containsExactly("group", "smoothing", "quality", "attribute");
        int base = (int) decoder.header().batches().end(0);
        assertThat(TestArchives.decode(bytes, base).mesh().faceChannels()).isEmpty();
    }

    @Test
    void shouldHardlySpendABitOnGroups() throws Exception {
        Mesh mesh = RandomMeshes.SPHERE.mesh(40);
        int[] group = new int[mesh.faces()];
        for (int f = 0; f < group.length; f++) group[f] = mesh.positions()[3 * mesh.vertex(f, 0)] > 0 ? 1 : 0;
        Mesh named = MeshBuilder.from(mesh)
                .faceChannels(List.of(
                        new FaceChannel(FaceChannel.GROUP, 1, Channel.Type.INT32, group, List.of("left", "right"))))
                .build();
        int without = TestArchives.encode(mesh).bytes().length;
        assertThat(TestArchives.encode(named).bytes().length).isLessThan(without + 60 + mesh.faces() / 8 / 3);
    }

    @Test
    void shouldKeepTheOrderOfAll() throws Exception {
        Mesh bare = RandomMeshes.GRID_WITH_HOLES.mesh(3);
        int[] values = new int[2 * bare.wedges()];
        for (int i = 0; i < bare.wedges(); i++) put(values, i, Channel.Type.FLOAT64, new Random(i));
        Mesh mesh = withFaceChannels(moved(
                AttributedMeshes.with(
                        bare, new Channel(Channel.Semantic.CUSTOM, "time", 1, Channel.Type.FLOAT64, values, null)),
                x -> x * Math.PI + 1000));
        byte[] bytes = TestArchives.encodeInOrder(mesh).bytes();
        Mesh decoded = TestArchives.decode(bytes, bytes.length).meshInOrder();
        assertThat(decoded.exactPositions()).isEqualTo(mesh.exactPositions());
        assertThat(decoded.faceWedges()).isEqualTo(mesh.faceWedges());
        assertThat(decoded.channels().get(0).values()).isEqualTo(values);
        for (int i = 0; i < 4; i++)
            assertThat(decoded.faceChannels().get(i).values())
                    .isEqualTo(mesh.faceChannels().get(i).values());
    }

    @Test
    void shouldRefuseDamageWithoutHarm() throws Exception {
        Mesh mesh = withFaceChannels(moved(RandomMeshes.GRID_WITH_HOLES.mesh(1), x -> x * Math.E + 70));
        byte[] good = TestArchives.encodeFar(mesh).bytes();
        BatchIndex index = TestArchives.decode(good, good.length).header().batches();
        Random random = new Random(3);
        int refused = 0;
        for (int i = 0; i < 400; i++) {
            byte[] bad = good.clone();
            int batch = random.nextInt(index.size());
            int from = (int) index.offset(batch);
            bad[from + random.nextInt(index.bytes(batch))] ^= (byte) (1 << random.nextInt(8));
            Checksums.mend(bad, index);
            try {
                TestArchives.decode(bad, bad.length).mesh();
            } catch (MalformedStreamException e) {
                refused++;
            }
        }
        assertThat(refused).isPositive();
    }

    /** Otherwise scalars of a scanner would keep visitors waiting for the shape. */
    @Test
    void shouldBringWhatNobodySeesAfterTheShape() throws Exception {
        Mesh bare = RandomMeshes.SPHERE.mesh(40);
        int[] quality = new Random(6)
                .doubles(bare.vertices())
                .mapToInt(x -> Float.floatToIntBits((float) x))
                .toArray();
        Mesh scanned = AttributedMeshes.with(
                bare, new Channel(Channel.Semantic.CUSTOM, "quality", 1, Channel.Type.FLOAT32, quality, null));
        assertThat(splitBytes(scanned)).isLessThan(splitBytes(bare) * 1.1);
    }

    private static double splitBytes(Mesh mesh) throws MalformedStreamException {
        byte[] bytes = TestArchives.encode(mesh).bytes();
        BatchIndex index = TestArchives.decode(bytes, bytes.length).header().batches();
        int sum = 0;
        for (int b = 0; b < index.size(); b++) if (index.kind(b) == BatchKind.SPLITS) sum += index.bytes(b);
        return sum;
    }

    private static Mesh whole(Mesh mesh) throws MalformedStreamException {
        byte[] bytes = TestArchives.encodeFar(mesh).bytes();
        return TestArchives.mesh(bytes);
    }
}
