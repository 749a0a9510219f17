package org.jsmesh.archive;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.stream.IntStream;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Tag("slow")
class MirrorArchiveTest {
    @ParameterizedTest
    @ValueSource(doubles = {0, 5, .25})
    void shouldSpendLittleOnPositionsOfImages(double sum) throws Exception {
        int mirrored = checked(halves(sum, 0, false, false));
        int others = checked(halves(sum, .003, false, false));
        assertThat(mirrored).isLessThan(others * 3 / 4);
    }

    @Test
    void shouldSpendLittleOnNormalsOfImages() throws Exception {
        int bare = checked(halves(0, 0, false, false));
        int half = (checked(halves(0, .003, true, false)) - checked(halves(0, .003, false, false))) / 2;
        assertThat(checked(halves(0, 0, true, false)) - bare).isLessThan(half * 13 / 10);
    }

    @Test
    void shouldSpendLittleOnTextureCoordinatesInChartsAlike() throws Exception {
        int bare = checked(halves(0, 0, false, false));
        int half = (checked(halves(0, .003, false, true)) - checked(halves(0, .003, false, false))) / 2;
        assertThat(checked(halves(0, 0, false, true)) - bare).isLessThan(half * 3 / 2);
    }

    private static int checked(Mesh mesh) throws Exception {
        byte[] bytes = TestArchives.encodeFar(mesh).bytes();
        assertThat(MeshIdentity.sha256(TestArchives.mesh(bytes))).isEqualTo(MeshIdentity.sha256(mesh));
        return bytes.length;
    }

    /**
     * A sphere and its image, whose positions are off by {@code noise} at random, with random normals or with texture
     * coordinates.
     */
    private static Mesh halves(double sum, double noise, boolean normals, boolean uv) {
        Mesh half = RandomMeshes.SPHERE.mesh(7);
        Random random = new Random(9);
        int n = half.vertices();
        float[] positions = new float[6 * n];
        int[] values = new int[(normals ? 3 : 2) * 2 * n];
        for (int v = 0; v < n; v++) {
            for (int a = 0; a < 3; a++) {
                double x = Math.rint(half.positions()[3 * v + a] * 1e6) / 1e6;
                double image = (a == 0 ? sum - x : x) + Math.rint(noise * random.nextGaussian() * 1e6) / 1e6;
                positions[3 * v + a] = (float) x;
                positions[3 * (n + v) + a] = (float) (Math.rint(image * 1e6) / 1e6);
                if (!normals && a == 2) continue;
                double value = normals ? random.nextGaussian() : x + random.nextGaussian() / 100;
                int at = (normals ? 3 : 2) * v + a;
                values[at] = Float.floatToIntBits((float) value);
                double other = normals ? a == 0 ? -value : value : a == 0 ? 3 + value : 2 - value;
                values[values.length / 2 + at] = Float.floatToIntBits((float) other);
            }
        }
        int[] corners = new int[6 * half.faces()];
        for (int f = 0; f < half.faces(); f++) {
            for (int j = 0; j < 3; j++) {
                corners[3 * f + j] = half.vertex(f, j);
                corners[3 * (half.faces() + f) + j] = n + half.vertex(f, 2 - j);
            }
        }
        MeshBuilder builder = new MeshBuilder().positions(positions).faceWedges(corners);
        if (!normals && !uv) return builder.build();
        Channel.Semantic semantic = normals ? Channel.Semantic.NORMAL : Channel.Semantic.TEXCOORD;
        Channel channel = new Channel(semantic, "c", normals ? 3 : 2, Channel.Type.FLOAT32, values, null);
        return builder.wedgeVertices(IntStream.range(0, 2 * n).toArray())
                .channels(java.util.List.of(channel))
                .build();
    }
}
