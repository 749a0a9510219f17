package org.jsmesh.archive;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.ClosedSurface;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** An archive says whether its original bounds a solid, so that viewers leave out faces that are seen from behind. */
class ClosedArchiveTest {
    @ParameterizedTest
    @EnumSource(
            value = RandomMeshes.class,
            names = {"SPHERE", "TORUS"})
    void shouldBeClosedAfterEveryBatch(RandomMeshes kind) throws Exception {
        Mesh mesh = kind.mesh(3);
        assertThat(ClosedSurface.is(mesh)).isTrue();
        byte[] bytes = encode(mesh);
        ArchiveDecoder decoder = new ArchiveDecoder();
        int seen = 0;
        for (int i = 0; i < bytes.length; i++) {
            decoder.feed(bytes, i, 1);
            if (decoder.batches() == seen) continue;
            seen = decoder.batches();
            assertThat(decoder.opening().isClosed()).isTrue();
            assertThat(ClosedSurface.is(decoder.mesh())).as("batch " + seen).isTrue();
        }
        assertThat(decoder.header().isClosed()).isTrue();
        assertThat(seen).isGreaterThan(3);
    }

    @Test
    void shouldNotSaySoOfASurfaceWithAHole() throws Exception {
        Mesh sphere = RandomMeshes.SPHERE.mesh(3);
        Mesh open = MeshBuilder.from(sphere)
                .faceWedges(Arrays.copyOf(sphere.faceWedges(), sphere.faceWedges().length - 3))
                .faceMaterials(Arrays.copyOf(sphere.faceMaterials(), sphere.faces() - 1))
                .build();
        byte[] bytes = encode(open);
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(bytes, 0, bytes.length);
        assertThat(decoder.opening().isClosed()).isFalse();
        assertThat(decoder.header().isClosed()).isFalse();
    }

    private static byte[] encode(Mesh mesh) {
        return new MeshEncoder(EncoderSettings.defaults().withBaseFaces(4))
                .encode(mesh, ProgressListener.NONE)
                .bytes();
    }
}
