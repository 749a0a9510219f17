package org.jsmesh.display;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Random;
import java.util.TreeMap;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.TestArchives;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.GrowingMesh;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class LiveMeshTest {
    private static final int SEEDS = 6;

    /** Feeds an archive in steps of some batches, and compares after each. */
    private static int follow(byte[] bytes, Random random) throws Exception {
        BatchIndex index = TestArchives.decode(bytes, bytes.length).header().batches();
        ArchiveDecoder decoder = new ArchiveDecoder();
        LiveMesh live = null;
        LiveMeshMirror mirror = new LiveMeshMirror();
        int at = 0;
        int steps = 0;
        for (int batch = 0; batch < index.size(); batch++) {
            if (batch + 1 < index.size() && random.nextInt(3) == 0) continue;
            int end = (int) index.end(batch);
            decoder.feed(bytes, at, end - at);
            at = end;
            if (live == null)
                live = new LiveMesh(decoder.growing(), decoder.opening().materials());
            Mesh mesh = decoder.mesh();
            double cosine = cosine(decoder);
            if (mesh.faceChannel(FaceChannel.SMOOTHING) != null) live.replace(mesh, cosine);
            else live.update(cosine);
            mirror.take(live);
            assertThat(live.faces()).isEqualTo(mesh.faces());
            assertThat(mirror.triangles())
                    .as("step %d, batch %d of %d", steps, batch, index.size())
                    .isDeepEqualTo(LiveMeshMirror.triangles(RenderMesh.of(mesh, cosine)));
            steps++;
        }
        return steps;
    }

    private static double cosine(ArchiveDecoder decoder) {
        int all =
                decoder.header() == null ? Integer.MAX_VALUE : decoder.header().faces();
        return CreaseAngle.cosine(decoder.faces(), decoder.index().faces(0), all);
    }

    @ParameterizedTest
    @EnumSource
    void shouldShowTheSameTrianglesAfterEachStep(RandomMeshes kind) throws Exception {
        for (int seed = 0; seed < SEEDS; seed++)
            assertThat(follow(TestArchives.encodeFar(kind.mesh(seed)).bytes(), new Random(seed)))
                    .isPositive();
    }

    @ParameterizedTest
    @EnumSource
    void shouldShowTheSameAttributesAfterEachStep(RandomMeshes kind) throws Exception {
        for (int seed = 0; seed < SEEDS; seed++) {
            Random random = new Random(seed);
            Mesh mesh = withAttributes(kind.mesh(seed), random);
            assertThat(follow(TestArchives.encodeFar(mesh).bytes(), random)).isPositive();
        }
    }

    /** Two sets of texture coordinates, colours, tangents; perhaps normals. Some wedges lack some of them. */
    private static Mesh withAttributes(Mesh bare, Random random) {
        List<Channel> channels = new ArrayList<>();
        Channel.Type colours =
                new Channel.Type[] {Channel.Type.UINT8, Channel.Type.UINT16, Channel.Type.FLOAT32}[random.nextInt(3)];
        channels.add(channel(bare, Channel.Semantic.COLOUR, "COLOR_0", 4, colours, random));
        channels.add(channel(bare, Channel.Semantic.TEXCOORD, "TEXCOORD_0", 2, Channel.Type.FLOAT32, random));
        channels.add(channel(bare, Channel.Semantic.TEXCOORD, "TEXCOORD_2", 2, Channel.Type.UINT16, random));
        channels.add(channel(bare, Channel.Semantic.CUSTOM, "TANGENT", 4, Channel.Type.FLOAT32, random));
        if (random.nextBoolean()) {
            Channel.Type type = random.nextBoolean() ? Channel.Type.FLOAT32 : Channel.Type.INT8;
            channels.add(channel(bare, Channel.Semantic.NORMAL, "NORMAL", 3, type, random));
        }
        return MeshBuilder.from(bare).channels(channels).build();
    }

    /** Values that depend on the place of the wedge and its number. */
    private static Channel channel(
            Mesh mesh, Channel.Semantic semantic, String name, int components, Channel.Type type, Random random) {
        int[] values = new int[components * mesh.wedges()];
        BitSet absent = new BitSet();
        boolean hasAbsent = random.nextBoolean();
        for (int i = 0; i < values.length; i++) {
            int wedge = i / components;
            if (hasAbsent && random.nextInt(9) == 0) absent.set(wedge);
            float x = mesh.positions()[3 * mesh.wedgeVertices()[wedge] + i % components % 3] + .01f * (wedge % 5);
            values[i] = type.isFloat() ? Float.floatToIntBits(x) : (int) (x * 50) & 127;
        }
        for (int i = 0; i < values.length; i++) if (absent.get(i / components)) values[i] = 0;
        return new Channel(semantic, name, components, type, values, absent);
    }

    @Test
    void shouldTakeOverSmoothingGroupsInTheEnd() throws Exception {
        Mesh bare = RandomMeshes.TORUS.mesh(2);
        int[] groups = new int[bare.faces()];
        for (int f = 0; f < groups.length; f++) groups[f] = f / 20;
        FaceChannel smoothing = new FaceChannel(FaceChannel.SMOOTHING, 1, Channel.Type.INT32, groups, List.of());
        Mesh mesh = MeshBuilder.from(bare).faceChannels(List.of(smoothing)).build();
        assertThat(follow(TestArchives.encodeFar(mesh).bytes(), new Random(2))).isPositive();
    }

    /** Other numbers are another order of the faces around a vertex, which the last bits of a sum depend on. */
    @Test
    void shouldFollowAMeshThatIsRenumberedByTheOrderOfArrival() throws Exception {
        byte[] bytes = TestArchives.encodeFar(torus(150, 110)).bytes();
        BatchIndex index = TestArchives.decode(bytes, bytes.length).header().batches();
        ArchiveDecoder decoder = new ArchiveDecoder();
        LiveMesh live = null;
        LiveMeshMirror mirror = new LiveMeshMirror();
        boolean isRenumbered = false;
        for (int batch = 0; batch < index.size(); batch++) {
            int at = batch == 0 ? 0 : (int) index.end(batch - 1);
            decoder.feed(bytes, at, (int) index.end(batch) - at);
            if (live == null)
                live = new LiveMesh(decoder.growing(), decoder.opening().materials());
            live.update(cosine(decoder));
            mirror.take(live);
            if (batch % 10 != 0 && batch + 1 < index.size()) continue;
            Mesh arrived = arrived(decoder.growing());
            isRenumbered |= !Arrays.equals(arrived.faceWedges(), decoder.mesh().faceWedges());
            assertThat(mirror.triangles())
                    .isDeepEqualTo(LiveMeshMirror.triangles(RenderMesh.of(arrived, cosine(decoder))));
            assertThat(MeshIdentity.sha256(arrived)).isEqualTo(MeshIdentity.sha256(decoder.mesh()));
        }
        assertThat(isRenumbered).isTrue();
    }

    private static Mesh arrived(GrowingMesh mesh) {
        float[] positions = new float[3 * mesh.vertices()];
        for (int i = 0; i < positions.length; i++) positions[i] = mesh.coordinate(i / 3, i % 3);
        TreeMap<Integer, Integer> vertices = new TreeMap<>(); // of corners
        int[] corners = new int[1000];
        for (int v = 0; v < mesh.vertices(); v++) {
            int n = mesh.corners(v, corners);
            for (int i = 0; i < GrowingMesh.CORNER * n; i += GrowingMesh.CORNER)
                vertices.put(3 * corners[i] + corners[i + 1], v);
        }
        int[] faceVertices =
                vertices.values().stream().mapToInt(Integer::intValue).toArray();
        return new MeshBuilder().positions(positions).faceWedges(faceVertices).build();
    }

    @Test
    void shouldStartFromThePictureBefore() throws Exception {
        assertThat(followStarts(torus(24, 16))).isGreaterThan(5);
        assertThat(followStarts(torus(150, 110))).isGreaterThan(10);
        assertThat(followStarts(RandomMeshes.GRID_WITH_SEAMS.mesh(3))).isGreaterThan(5);
    }

    /** Where all vertices start from, there is the picture of the step before, and nothing else but flat triangles. */
    private static int followStarts(Mesh mesh) throws Exception {
        byte[] bytes = TestArchives.encodeFar(mesh).bytes();
        BatchIndex index = TestArchives.decode(bytes, bytes.length).header().batches();
        ArchiveDecoder decoder = new ArchiveDecoder();
        LiveMesh live = null;
        LiveMeshMirror mirror = new LiveMeshMirror();
        int[][] before = null;
        int at = 0;
        int steps = 0;
        for (int batch = 0; batch < index.size(); batch++) {
            decoder.feed(bytes, at, (int) index.end(batch) - at);
            at = (int) index.end(batch);
            if (live == null)
                live = new LiveMesh(decoder.growing(), decoder.opening().materials());
            live.update(cosine(decoder));
            mirror.take(live);
            if (before != null) assertThat(mirror.starts()).as("step %d", steps).isDeepEqualTo(before);
            before = mirror.ends();
            steps++;
        }
        return steps;
    }

    @Test
    void shouldTellWhichSlotsHaveTangents() throws Exception {
        Mesh bare = RandomMeshes.TORUS_WITH_MATERIALS.mesh(1);
        int[] values = new int[4 * bare.wedges()];
        Arrays.fill(values, Float.floatToIntBits(.5f));
        Channel tangents =
                new Channel(Channel.Semantic.CUSTOM, "TANGENT", 4, Channel.Type.FLOAT32, values, new BitSet());
        List<Material> materials = new ArrayList<>();
        for (int i = 0; i < 3; i++)
            materials.add(new Material("m" + i, List.of(), List.of(), "{\"name\":\"" + i + "\"}"));
        Mesh mesh = MeshBuilder.from(bare)
                .channels(List.of(tangents))
                .materials(materials)
                .build();
        assertThat(tangentSlots(mesh)).containsExactly(0, 1, 2, 3);
        int wedge = 0;
        for (int f = 0; f < mesh.faces(); f++) if (mesh.faceMaterials()[f] == 1) wedge = mesh.faceWedges()[3 * f];
        BitSet absent = new BitSet();
        absent.set(wedge);
        Arrays.fill(values, 4 * wedge, 4 * wedge + 4, 0);
        Mesh some = MeshBuilder.from(mesh)
                .channels(List.of(tangents.withValues(values, absent)))
                .build();
        assertThat(tangentSlots(some)).contains(0).doesNotContain(2);
        assertThat(tangentSlots(bare)).isEmpty();
    }

    private static int[] tangentSlots(Mesh mesh) throws Exception {
        byte[] bytes = TestArchives.encodeFar(mesh).bytes();
        ArchiveDecoder decoder = TestArchives.decode(bytes, bytes.length);
        LiveMesh live = new LiveMesh(decoder.growing(), decoder.opening().materials());
        live.update(.7);
        return live.slotsWithTangents();
    }

    @Test
    void shouldSendNothingWhenNothingHasChanged() throws Exception {
        byte[] bytes = TestArchives.encodeFar(torus(24, 16)).bytes();
        ArchiveDecoder decoder = TestArchives.decode(bytes, bytes.length);
        LiveMesh live = new LiveMesh(decoder.growing(), decoder.opening().materials());
        live.update(.7);
        assertThat(live.ranges()).isPositive();
        live.update(.7);
        assertThat(live.ranges()).isZero();
        assertThat(live.step()).isEqualTo(2);
    }

    @Test
    void shouldSendLessThanWholeMeshesInFewRanges() throws Exception {
        byte[] bytes = TestArchives.encodeFar(torus(60, 40)).bytes();
        BatchIndex index = TestArchives.decode(bytes, bytes.length).header().batches();
        ArchiveDecoder decoder = new ArchiveDecoder();
        LiveMesh live = null;
        LiveMeshMirror mirror = new LiveMeshMirror();
        long sent = 0;
        long whole = 0;
        for (int batch = 0; batch < index.size(); batch++) {
            int at = batch == 0 ? 0 : (int) index.end(batch - 1);
            decoder.feed(bytes, at, (int) index.end(batch) - at);
            if (live == null)
                live = new LiveMesh(decoder.growing(), decoder.opening().materials());
            live.update(cosine(decoder));
            mirror.take(live);
            assertThat(mirror.ranges).isLessThanOrEqualTo(256);
            sent += mirror.elements;
            whole += 10L * live.vertices() + 3L * live.faces();
        }
        assertThat(sent).isLessThan(whole / 2);
    }

    private static Mesh torus(int around, int along) {
        float[] positions = new float[3 * around * along];
        int[] faces = new int[6 * around * along];
        int at = 0;
        for (int j = 0; j < along; j++) {
            for (int i = 0; i < around; i++) {
                double u = 2 * Math.PI * i / around;
                double v = 2 * Math.PI * j / along;
                double r = .4 + .05 * Math.sin(9 * u) * Math.cos(4 * v);
                int a = j * around + i;
                positions[3 * a] = (float) ((1 + r * Math.cos(v)) * Math.cos(u));
                positions[3 * a + 1] = (float) (r * Math.sin(v));
                positions[3 * a + 2] = (float) ((1 + r * Math.cos(v)) * Math.sin(u));
                int b = (j + 1) % along * around + i;
                int right = j * around + (i + 1) % around;
                int across = (j + 1) % along * around + (i + 1) % around;
                for (int w : new int[] {a, b, right, right, b, across}) faces[at++] = w;
            }
        }
        return new MeshBuilder().positions(positions).faceWedges(faces).build();
    }
}
