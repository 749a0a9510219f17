package org.jsmesh.encode;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.BatchKind;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;

class PosterBatchTest {
    private static final byte[] POSTER = new byte[5000];

    static {
        for (int i = 0; i < POSTER.length; i++) POSTER[i] = (byte) (i * i);
    }

    private static final EncoderSettings SETTINGS = EncoderSettings.defaults().withUp(UpAxis.Z);
    private final Mesh mesh = RandomMeshes.SPHERE.mesh(3);
    private final EncodedArchive plain = new MeshEncoder(SETTINGS).encode(mesh, ProgressListener.NONE);
    private final EncodedArchive shown =
            new MeshEncoder(SETTINGS).withPoster((m, up) -> POSTER).encode(mesh, ProgressListener.NONE);

    @Test
    void shouldComeLastAndWhole() {
        BatchIndex index = shown.header().batches();
        int batch = index.poster();
        assertThat(index.kind(batch)).isEqualTo(BatchKind.POSTER);
        long end = index.offset(batch) + BatchIndex.payloadBytes(index.bytes(batch));
        assertThat(Arrays.copyOfRange(shown.bytes(), (int) index.offset(batch), (int) end))
                .isEqualTo(POSTER);
        for (int i = batch + 1; i < index.size(); i++) assertThat(index.kind(i)).isEqualTo(BatchKind.HEADER);
    }

    @Test
    void shouldCostNothingButItself() {
        int posterAndRow = POSTER.length + 16;
        assertThat(shown.bytes())
                .hasSizeBetween(plain.bytes().length + POSTER.length, plain.bytes().length + posterAndRow);
        assertThat(plain.header().batches().poster()).isNegative();
    }

    @Test
    void shouldLeaveTheOriginalAndItsIdentityAsTheyAre() throws Exception {
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(shown.bytes(), 0, shown.bytes().length);
        assertThat(decoder.isComplete()).isTrue();
        assertThat(MeshIdentity.sha256(decoder.mesh(), PlatformHash.sha256()))
                .isEqualTo(plain.header().meshSha256());
        assertThat(shown.header().modelSha256()).isEqualTo(plain.header().modelSha256());
    }

    @Test
    void shouldHaveNoPosterAgainstTheSettings() {
        EncodedArchive without = new MeshEncoder(SETTINGS.withPoster(false))
                .withPoster((m, up) -> POSTER)
                .encode(mesh, ProgressListener.NONE);
        assertThat(without.bytes()).isEqualTo(plain.bytes());
        EncodedArchive empty =
                new MeshEncoder(SETTINGS).withPoster((m, up) -> new byte[0]).encode(mesh, ProgressListener.NONE);
        assertThat(empty.bytes()).isEqualTo(plain.bytes());
    }

    @Test
    void shouldGiveThePainterTheCleanedMeshAndTheAxis() throws Exception {
        ExecutorService helpers = Executors.newFixedThreadPool(1);
        try {
            PosterPainter painter = (m, up) -> new byte[] {(byte) up.ordinal(), (byte) m.faces()};
            EncodedArchive archive = new MeshEncoder(SETTINGS.withThreads(2), helpers)
                    .withPoster(painter)
                    .encode(mesh, ProgressListener.NONE);
            int at = (int)
                    archive.header().batches().offset(archive.header().batches().poster());
            assertThat(archive.bytes()[at]).isEqualTo((byte) UpAxis.Z.ordinal());
            assertThat(archive.bytes()[at + 1]).isEqualTo((byte) mesh.faces());
        } finally {
            helpers.shutdown();
        }
    }

    @Test
    void shouldBeRefusedWhenItIsDamaged() {
        byte[] damaged = shown.bytes().clone();
        BatchIndex index = shown.header().batches();
        damaged[(int) index.offset(index.poster()) + 100] ^= 1;
        ArchiveDecoder decoder = new ArchiveDecoder();
        assertThatThrownBy(() -> decoder.feed(damaged, 0, damaged.length))
                .isInstanceOf(MalformedStreamException.class)
                .hasMessageContaining("checksum");
        assertThat(decoder.faces()).isEqualTo(mesh.faces());
    }
}
