package org.jsmesh.encode;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshCleaner;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.test.FastSet;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Meshes that no modeller makes on purpose: they come back bit for bit, or are refused with a reason and a remedy. */
class StrangeMeshesTest {
    private static final String LARGE = ".*000.*|LONG_.*|SEPARATE_.*";

    @ParameterizedTest
    @EnumSource(names = LARGE, mode = EnumSource.Mode.MATCH_NONE)
    void shouldComeBackBitForBit(StrangeMesh kind) throws Exception {
        checkRoundTrips(kind);
    }

    @Tag("long")
    @ParameterizedTest
    @EnumSource(names = LARGE, mode = EnumSource.Mode.MATCH_ANY)
    void shouldComeBackBitForBitThoughLarge(StrangeMesh kind) throws Exception {
        checkRoundTrips(kind);
    }

    private static void checkRoundTrips(StrangeMesh kind) throws Exception {
        EncoderSettings common = EncoderSettings.defaults().withBaseFaces(4).withKeepOrder(true);
        List<Quality> qualities = FastSet.isOn() ? List.of(Quality.DEFAULT) : List.of(Quality.values());
        for (Quality quality : qualities) checkRoundTrip(kind.mesh(), common.withQuality(quality));
        checkRoundTrip(kind.mesh(), common.withSimplifier(Simplifier.PAPER).withLevels(List.of(.1, .5, 10.0)));
    }

    private static void checkRoundTrip(Mesh mesh, EncoderSettings settings) throws Exception {
        byte[] bytes =
                new MeshEncoder(settings).encode(mesh, ProgressListener.NONE).bytes();
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(bytes, 0, bytes.length);
        assertThat(MeshIdentity.sha256(decoder.mesh()))
                .isEqualTo(MeshIdentity.sha256(MeshCleaner.clean(mesh, new ArrayList<>())));
        Mesh back = decoder.meshInOrder();
        assertThat(bits(back)).isEqualTo(bits(mesh));
        assertThat(back.faceWedges()).isEqualTo(mesh.faceWedges());
        for (int b = 0; b < decoder.index().size(); b++)
            assertThat(decoder.index().errorMean(b)).isBetween(0.0, 100.0);
    }

    /** The first picture of a crowd is a thinner crowd, and comes with the first bytes. */
    @Tag("slow")
    @ParameterizedTest
    @EnumSource(names = {"SEPARATE_TRIANGLES", "SEPARATE_TETRAHEDRA"})
    void shouldShowManyComponentsEarly(StrangeMesh kind) throws Exception {
        Mesh mesh = kind.mesh();
        byte[] bytes = new MeshEncoder(EncoderSettings.defaults())
                .encode(mesh, ProgressListener.NONE)
                .bytes();
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(bytes, 0, 2000);
        assertThat(decoder.batches()).isPositive();
        Mesh first = decoder.mesh();
        assertThat(first.faces()).isBetween(80, 2000);
        float[] box = mesh.bounds();
        float[] shown = first.bounds();
        for (int a = 0; a < 2; a++) { // the third side is short, and positions are coarse
            double side = box[a + 3] - box[a];
            assertThat((shown[a + 3] - shown[a]) / side).isBetween(.85, 1.15);
        }
        BatchIndex index = decoder.index();
        assertThat(index.errorMean(0)).isLessThan(3);
        decoder.feed(bytes, 2000, bytes.length - 2000);
        assertThat(MeshIdentity.sha256(decoder.mesh())).isEqualTo(MeshIdentity.sha256(mesh));
        index = decoder.index();
        for (int b = 1; b < index.size(); b++) assertThat(index.bytes(b)).isLessThan(66_000);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 9})
    void shouldRefuseAMeshWithoutFaces(int coordinates) {
        assertRefused(
                new MeshBuilder()
                        .positions(new float[coordinates])
                        .faceWedges(new int[0])
                        .build(),
                "no faces",
                coordinates == 0 ? "Give a model with faces" : "Make a mesh of the points");
    }

    @ParameterizedTest
    @ValueSource(floats = {Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY})
    void shouldRefuseNumbersThatAreNotFinite(float value) {
        Mesh grid = StrangeMesh.grid(10, 1, 0);
        float[] one = grid.positions().clone();
        one[3 * 17 + 1] = value;
        assertRefused(with(grid, one), "y of vertex 17 is " + value, "finite", "Mend that vertex");
        float[] all = new float[one.length];
        Arrays.fill(all, value);
        assertRefused(with(grid, all), "x of vertex 0 is " + value, "Mend that vertex");
        int[] normals = new int[3 * grid.vertices()];
        normals[3 * 5 + 2] = Float.floatToRawIntBits(value);
        Mesh shaded = MeshBuilder.from(grid)
                .channels(
                        List.of(new Channel(Channel.Semantic.NORMAL, "normal", 3, Channel.Type.FLOAT32, normals, null)))
                .build();
        assertRefused(shaded, "normal of vertex 5 is " + value, "Mend that vertex");
    }

    @Test
    void shouldLookAtVerticesWithoutFacesOnlyWhenTheyAreKept() {
        Mesh mesh = new MeshBuilder()
                .positions(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, Float.NaN, 0, 0})
                .faceWedges(new int[] {0, 1, 2})
                .build();
        EncodedArchive archive = new MeshEncoder(EncoderSettings.defaults()).encode(mesh, ProgressListener.NONE);
        assertThat(archive.header().vertices()).isEqualTo(3);
        assertThatThrownBy(() -> new MeshEncoder(EncoderSettings.defaults().withKeepOrder(true))
                        .encode(mesh, ProgressListener.NONE))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("x of vertex 3 is NaN");
    }

    private static Mesh with(Mesh mesh, float[] positions) {
        return MeshBuilder.from(mesh).positions(positions).build();
    }

    private static int[] bits(Mesh mesh) {
        int[] bits = new int[mesh.positions().length];
        for (int i = 0; i < bits.length; i++) bits[i] = Float.floatToRawIntBits(mesh.positions()[i]);
        return bits;
    }

    private static void assertRefused(Mesh mesh, String... words) {
        assertThatThrownBy(() -> new MeshEncoder(EncoderSettings.defaults()).encode(mesh, ProgressListener.NONE))
                .isInstanceOf(IllegalArgumentException.class)
                .message()
                .contains(words);
    }
}
