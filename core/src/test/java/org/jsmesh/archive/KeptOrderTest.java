package org.jsmesh.archive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.lifecycle.AddLifecycleHook;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.test.FewerTries;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

@AddLifecycleHook(FewerTries.class)
class KeptOrderTest {
    @Property(tries = 150, seed = "20031")
    void shouldGiveBackTheArraysOfAnyMesh(@ForAll RandomMeshes kind, @ForAll long seed) throws Exception {
        Mesh mesh = kind.mesh(seed);
        assertSame(decode(encode(mesh)).meshInOrder(), mesh);
    }

    @Test
    void shouldGiveBackVerticesThatNoFaceUses() throws Exception {
        float[] positions = {9, 9, 9, 0, 0, 0, 1, 0, 0, -0f, 5, 1e-40f, 0, 1, 0, 0, 0, 0};
        Mesh mesh = new MeshBuilder()
                .positions(positions)
                .faceWedges(new int[] {4, 1, 2})
                .build();
        assertSame(decode(encode(mesh)).meshInOrder(), mesh);
    }

    @Test
    void shouldGiveBackMaterialsThatNoFaceUses() throws Exception {
        Material used = new Material("used", List.of(), List.of());
        Material unused = new Material("unused", List.of(), List.of(new Material.TextureReference("map_Kd", "a.png")));
        Mesh mesh = new MeshBuilder()
                .positions(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0})
                .faceWedges(new int[] {0, 1, 2})
                .materials(List.of(unused, used))
                .faceMaterials(new int[] {1})
                .build();
        EncodedArchive archive = TestArchives.encodeInOrder(mesh);
        assertSame(decode(archive.bytes()).meshInOrder(), mesh);
        assertThat(archive.notes()).isEmpty();
    }

    @Test
    void shouldShowTheOrdinaryMeshUntilThen() throws Exception {
        Mesh mesh = RandomMeshes.TORUS.mesh(3);
        byte[] bytes = encode(mesh);
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(bytes, 0, bytes.length - 1);
        assertThat(decoder.mesh().faces()).isEqualTo(mesh.faces());
        assertThatThrownBy(decoder::meshInOrder).isInstanceOf(IllegalStateException.class);
    }

    @ParameterizedTest
    @EnumSource
    void shouldSurviveADamagedOrder(RandomMeshes kind) throws Exception {
        byte[] bytes = encode(kind.mesh(9));
        BatchIndex index = decode(bytes).header().batches();
        int from = 0;
        while (index.kind(from) != BatchKind.ORDER) from++;
        int start = (int) index.offset(from);
        int end = from;
        while (end < index.size() && index.kind(end) == BatchKind.ORDER) end++;
        int length = (int) index.end(end - 1) - start;
        Random random = new Random(10);
        for (int i = 0; i < 60; i++) {
            byte[] damaged = bytes.clone();
            for (int k = 0; k < 3; k++) damaged[start + random.nextInt(length)] = (byte) random.nextInt();
            Checksums.mend(damaged, index);
            try {
                Mesh mesh = decode(damaged).meshInOrder();
                assertThat(mesh.faces()).isEqualTo(index.faces(index.size() - 1));
            } catch (MalformedStreamException e) {
                assertThat(e.getMessage()).isNotBlank();
            }
        }
    }

    private static byte[] encode(Mesh mesh) {
        return TestArchives.encodeInOrder(mesh).bytes();
    }

    private static ArchiveDecoder decode(byte[] bytes) throws MalformedStreamException {
        return TestArchives.decode(bytes, bytes.length);
    }

    private static void assertSame(Mesh actual, Mesh expected) {
        assertThat(bits(actual.positions())).isEqualTo(bits(expected.positions()));
        assertThat(actual.wedgeVertices()).isEqualTo(expected.wedgeVertices());
        assertThat(actual.faceWedges()).isEqualTo(expected.faceWedges());
        assertThat(actual.materials()).isEqualTo(expected.materials());
        assertThat(actual.faceMaterials()).isEqualTo(expected.faceMaterials());
        assertThat(actual.channels()).hasSameSizeAs(expected.channels());
        for (int i = 0; i < expected.channels().size(); i++) {
            Channel a = actual.channels().get(i);
            Channel b = expected.channels().get(i);
            assertThat(a.values()).isEqualTo(b.values());
            for (int w = 0; w < expected.wedges(); w++)
                assertThat(a.isAbsent(w)).isEqualTo(b.isAbsent(w));
        }
    }

    private static int[] bits(float[] values) {
        int[] bits = new int[values.length];
        for (int i = 0; i < bits.length; i++) bits[i] = Float.floatToRawIntBits(values[i]);
        return bits;
    }
}
