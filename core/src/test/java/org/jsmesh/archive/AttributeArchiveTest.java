package org.jsmesh.archive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.function.IntToDoubleFunction;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class AttributeArchiveTest {
    @ParameterizedTest
    @CsvSource({"area, true", "area, false", "uniform, true", "uniform, false", "angle, true", "angle, false"})
    void shouldHardlySpendABitOnComputedNormals(String weights, boolean unit) throws Exception {
        Mesh bare = RandomMeshes.SPHERE.mesh(7);
        Mesh mesh = AttributedMeshes.withNormals(bare, AttributedMeshes.normals(bare, weights, unit), null);
        byte[] bytes = checked(mesh);
        assertThat(bytes.length - TestArchives.encodeFar(bare).bytes().length).isLessThan(80 + mesh.wedges() / 4);
    }

    @Test
    void shouldShowComputedNormalsUntilTheExactOnesCome() throws Exception {
        Mesh bare = RandomMeshes.TORUS.mesh(3);
        float[] others = AttributedMeshes.normals(bare, "area", true);
        for (int i = 0; i < others.length; i++) others[i] += .001f * (i % 7 - 3);
        byte[] bytes = checked(AttributedMeshes.withNormals(bare, others, null));
        BatchIndex index = TestArchives.decode(bytes, bytes.length).header().batches();
        int last = index.size() - 1;
        if (index.kind(last) == BatchKind.HEADER) last--; // the archive is that small
        assertThat(index.kind(last)).isEqualTo(BatchKind.ATTRIBUTES);
        Mesh early = TestArchives.decode(bytes, (int) index.end(0)).mesh();
        float[] expected = AttributedMeshes.normals(early, "area", true);
        Channel shown = early.channels().get(0);
        for (int i = 0; i < expected.length; i++)
            assertThat(shown.number(i / 3, i % 3)).isCloseTo(expected[i], within(1e-6f));
    }

    @Test
    void shouldHardlySpendABitOnNormalsInTheMiddleOfPolygons() throws Exception {
        Mesh bare = RandomMeshes.SPHERE.mesh(7);
        int n = bare.vertices();
        int faces = bare.faces();
        float[] positions = Arrays.copyOf(bare.positions(), 3 * (n + faces));
        int[] corners = new int[9 * faces];
        float[] normals = new float[positions.length];
        Random random = new Random(4);
        for (int i = 0; i < 3 * n; i++) normals[i] = (float) random.nextGaussian();
        for (int f = 0; f < faces; f++) {
            for (int j = 0; j < 3; j++) {
                corners[9 * f + 3 * j] = bare.vertex(f, j);
                corners[9 * f + 3 * j + 1] = bare.vertex(f, (j + 1) % 3);
                corners[9 * f + 3 * j + 2] = n + f;
            }
            for (int k = 0; k < 3; k++) {
                double position = 0;
                double normal = 0;
                for (int j = 0; j < 3; j++) {
                    position += positions[3 * bare.vertex(f, j) + k];
                    normal += normals[3 * bare.vertex(f, j) + k];
                }
                positions[3 * (n + f) + k] = (float) (position / 3);
                normals[3 * (n + f) + k] = (float) (normal / 3);
            }
        }
        Mesh mesh = new MeshBuilder().positions(positions).faceWedges(corners).build();
        int without = TestArchives.encodeFar(mesh).bytes().length;
        byte[] bytes = checked(AttributedMeshes.withNormals(mesh, normals, null));
        assertThat(bytes.length - without).isLessThan(150 + 12 * n + faces / 2);
    }

    @Test
    void shouldKeepNormalsOfEveryKind() throws Exception {
        Mesh bare = RandomMeshes.GRID_WITH_HOLES.mesh(5);
        Random random = new Random(1);
        List<IntToDoubleFunction> kinds = List.of(
                i -> 0,
                i -> -0.0,
                i -> i % 3 == 2 ? 1 : 0,
                i -> random.nextGaussian(),
                i -> random.nextGaussian() * 1e-38,
                i -> random.nextGaussian() * 1e38,
                i -> i % 7 == 0 ? Float.MIN_VALUE : random.nextInt(3) - 1,
                i -> i % 5 == 0 ? -Float.MAX_VALUE : Math.rint(random.nextGaussian() * 1000) / 1000);
        for (IntToDoubleFunction kind : kinds) {
            float[] normals = new float[3 * bare.vertices()];
            for (int i = 0; i < normals.length; i++)
                normals[i] = (float) Math.max(-Float.MAX_VALUE, Math.min(Float.MAX_VALUE, kind.applyAsDouble(i)));
            BitSet absent = new BitSet();
            for (int v = 0; v < bare.vertices(); v++) {
                if (random.nextInt(4) > 0) continue;
                absent.set(v);
                Arrays.fill(normals, 3 * v, 3 * v + 3, 0);
            }
            checked(AttributedMeshes.withNormals(bare, normals, absent));
        }
    }

    @Test
    void shouldSendTextureCoordinatesCoarseFirst() throws Exception {
        Mesh bare = RandomMeshes.SPHERE.mesh(11);
        int[] uv = new int[2 * bare.vertices()];
        for (int i = 0; i < uv.length; i++)
            uv[i] = Float.floatToIntBits((float) Math.sin(bare.positions()[i / 2 * 3 + i % 2]));
        Mesh mesh = AttributedMeshes.with(
                bare, new Channel(Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, uv, null));
        byte[] bytes = checked(mesh);
        Mesh coarse = beforeAttributes(bytes);
        assertThat(coarse.positions()).hasSize(mesh.positions().length);
        Channel shown = coarse.channels().get(0);
        for (int w = 0; w < coarse.wedges(); w++) {
            for (int k = 0; k < 2; k++) {
                double x = coarse.positions()[3 * coarse.wedgeVertices()[w] + k];
                assertThat((double) shown.number(w, k)).isCloseTo(Math.sin(x), within(.01));
            }
        }
    }

    @Test
    void shouldSendColoursCoarseFirst() throws Exception {
        Mesh bare = RandomMeshes.SPHERE.mesh(11);
        int[] rgba = new int[4 * bare.vertices()];
        for (int i = 0; i < rgba.length; i++) {
            double x = i % 4 == 3 ? 9 : bare.positions()[i / 4 * 3 + i % 4];
            rgba[i] = (int) Math.max(0, Math.min(255, 127 + 200 * x));
        }
        byte[] bytes = checked(AttributedMeshes.with(
                bare, new Channel(Channel.Semantic.COLOUR, "rgba", 4, Channel.Type.UINT8, rgba, null)));
        Mesh coarse = beforeAttributes(bytes);
        Channel shown = coarse.channels().get(0);
        for (int w = 0; w < coarse.wedges(); w++) {
            for (int k = 0; k < 4; k++) {
                double x = k == 3 ? 9 : coarse.positions()[3 * coarse.wedgeVertices()[w] + k];
                int exact = (int) Math.max(0, Math.min(255, 127 + 200 * x));
                int value = shown.values()[4 * w + k];
                assertThat(value).isCloseTo(exact, within(exact == 0 || exact == 255 ? 0 : 7));
            }
        }
        assertThat(shown.values()).doesNotContain(254, 253, 252);
    }

    @Test
    void shouldMakeColoursExactBeforePositions() throws Exception {
        Mesh bare = RandomMeshes.SPHERE.mesh(11);
        float[] uneven = bare.positions().clone();
        for (int i = 0; i < uneven.length; i++) uneven[i] += (float) (i % 97 * 1e-7);
        int[] rgb = new int[3 * bare.vertices()];
        int[] uv = new int[2 * bare.vertices()];
        for (int i = 0; i < rgb.length; i++) rgb[i] = (int) (127 + 120 * Math.sin(9 * uneven[i]));
        for (int i = 0; i < uv.length; i++) uv[i] = Float.floatToIntBits((float) Math.sin(uneven[i]));
        byte[] bytes = checked(new MeshBuilder()
                .positions(uneven)
                .faceWedges(bare.faceWedges())
                .channels(List.of(
                        new Channel(Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, uv, null),
                        new Channel(Channel.Semantic.COLOUR, "rgb", 3, Channel.Type.UINT8, rgb, null)))
                .build());
        BatchIndex index = TestArchives.decode(bytes, bytes.length).header().batches();
        int last = index.size() - 1;
        while (index.kind(last) != BatchKind.PRECISION) last--;
        int batch = last;
        while (index.kind(batch) != BatchKind.ATTRIBUTES) batch--;
        assertThat(index.kind(last + 1)).isEqualTo(BatchKind.ATTRIBUTES); // the texture coordinates
        Mesh shown = TestArchives.decode(bytes, (int) index.end(batch)).mesh();
        assertThat(index.precisionBits(batch)).isLessThan(32);
        Map<Integer, Long> wanted = new TreeMap<>();
        for (int v : rgb) wanted.merge(v, 1L, Long::sum);
        Map<Integer, Long> there = new TreeMap<>();
        for (int v : shown.channel(Channel.Semantic.COLOUR).values()) there.merge(v, 1L, Long::sum);
        assertThat(there).isEqualTo(wanted);
    }

    @Test
    void shouldKeepOtherBytesTogether() throws Exception {
        Mesh bare = RandomMeshes.SPHERE.mesh(11);
        int[] labels = new Random(5).ints(bare.vertices(), 0, 256).toArray();
        Channel channel = new Channel(Channel.Semantic.CUSTOM, "label", 1, Channel.Type.UINT8, labels, null);
        byte[] bytes = checked(AttributedMeshes.with(bare, channel));
        BatchIndex index = TestArchives.decode(bytes, bytes.length).header().batches();
        for (int b = 0; b < index.size(); b++) assertThat(index.kind(b)).isNotEqualTo(BatchKind.ATTRIBUTES);
    }

    @Test
    void shouldKeepTextureCoordinatesThatWereTurnedOver() throws Exception {
        Mesh bare = RandomMeshes.SPHERE.mesh(11);
        BitSet absent = new BitSet();
        absent.set(3);
        int[] uv = new int[2 * bare.vertices()];
        int[] turned = uv.clone();
        for (int i = 0; i < uv.length; i++) {
            if (i / 2 == 3) continue;
            float x = Math.round((bare.positions()[i / 2 * 3 + i % 2] + 2) * 200_000) / 1e6f;
            if (i % 20 == 1) x += .25e-6f; // not all are decimals
            uv[i] = Float.floatToIntBits(x);
            turned[i] = Float.floatToIntBits(i % 2 == 0 ? x : 1 - x);
        }
        byte[] bytes = checked(AttributedMeshes.with(
                bare, new Channel(Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, uv, absent)));
        byte[] turnedBytes = checked(AttributedMeshes.with(
                bare, new Channel(Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, turned, absent)));
        assertThat(turnedBytes.length).isLessThan(bytes.length + bare.vertices() / 4);
    }

    @Test
    void shouldHardlySpendABitOnTextureCoordinatesThatComeTwice() throws Exception {
        Mesh bare = RandomMeshes.TORUS.mesh(5);
        int n = bare.vertices();
        int[] corners = Arrays.copyOf(bare.faceWedges(), 6 * bare.faces());
        for (int i = 3 * bare.faces(); i < corners.length; i++) corners[i] = corners[i - 3 * bare.faces()] + n;
        float[] positions = Arrays.copyOf(bare.positions(), 6 * n);
        for (int i = 3 * n; i < positions.length; i++) positions[i] = positions[i - 3 * n] + 10;
        Random random = new Random(2);
        int[] once = random.doubles(4 * n)
                .mapToInt(x -> Float.floatToIntBits((float) x))
                .toArray();
        int[] twice = once.clone();
        System.arraycopy(once, 0, twice, 2 * n, 2 * n);
        int[] lengths = new int[2];
        for (int i = 0; i < 2; i++) {
            int[] uv = i == 0 ? once : twice;
            lengths[i] = checked(new MeshBuilder()
                            .positions(positions)
                            .faceWedges(corners)
                            .channels(List.of(
                                    new Channel(Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, uv, null)))
                            .build())
                    .length;
        }
        assertThat(lengths[1]).isLessThan(lengths[0] - 2 * n); // of about 60 bits of 96 per pair
    }

    @Test
    void shouldSpendLittleMoreOnGreyThanOnOneComponent() throws Exception {
        Mesh bare = RandomMeshes.SPHERE.mesh(13);
        Random random = new Random(3);
        int[] one = random.ints(bare.vertices(), 0, 256).toArray();
        int[] grey = new int[4 * one.length];
        for (int i = 0; i < grey.length; i++) grey[i] = i % 4 == 3 ? 255 : one[i / 4];
        int oneLength = checked(AttributedMeshes.with(
                        bare, new Channel(Channel.Semantic.COLOUR, "c", 1, Channel.Type.UINT8, one, null)))
                .length;
        int greyLength = checked(AttributedMeshes.with(
                        bare, new Channel(Channel.Semantic.COLOUR, "c", 4, Channel.Type.UINT8, grey, null)))
                .length;
        assertThat(greyLength).isLessThan(oneLength + 30 + one.length / 4);
    }

    /** The mesh of exact positions, but coarse attributes. */
    private static Mesh beforeAttributes(byte[] bytes) throws Exception {
        BatchIndex index = TestArchives.decode(bytes, bytes.length).header().batches();
        int first = 0;
        while (index.kind(first) != BatchKind.ATTRIBUTES) first++;
        return TestArchives.decode(bytes, (int) index.end(first - 1)).mesh();
    }

    private static byte[] checked(Mesh mesh) throws Exception {
        byte[] bytes = TestArchives.encodeFar(mesh).bytes();
        ArchiveDecoder decoder = TestArchives.decode(bytes, bytes.length);
        assertThat(MeshIdentity.sha256(decoder.mesh()))
                .isEqualTo(decoder.header().meshSha256());
        return bytes;
    }
}
