package org.jsmesh.encode;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.util.List;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.write.HugeArchive;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.Texture;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

class EncodedArchiveTest {
    private static final Mesh TETRAHEDRON = new MeshBuilder()
            .positions(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1})
            .faceWedges(new int[] {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2})
            .build();

    private static HugeArchive huge;

    @BeforeAll
    static void makeHuge() throws IOException {
        huge = HugeArchive.of(TETRAHEDRON);
    }

    @Test
    void shouldGiveTheSameBytesAsAnArrayAndAsAStream() throws IOException {
        byte[] image = new byte[200_000];
        for (int i = 0; i < image.length; i++) image[i] = (byte) (i * 31 + i / 256);
        Material material = new Material("m", List.of(), List.of(new Material.TextureReference("map_Kd", "a.png")));
        Mesh mesh = MeshBuilder.from(TETRAHEDRON)
                .materials(List.of(material))
                .faceMaterials(new int[4])
                .textures(List.of(new Texture("a.png", image)))
                .build();
        EncodedArchive archive = new MeshEncoder(EncoderSettings.defaults()).encode(mesh, ProgressListener.NONE);
        ByteArrayOutputStream written = new ByteArrayOutputStream();
        archive.writeTo(written);
        assertThat(written.toByteArray()).isEqualTo(archive.bytes()).hasSize((int) archive.length());
        assertThat(archive.open().readAllBytes()).isEqualTo(archive.bytes());
        assertThat(archive.length()).isEqualTo(archive.header().batches().archiveBytes());
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(archive.bytes(), 0, (int) archive.length());
        assertThat(decoder.mesh().textures().get(0).bytes()).isEqualTo(image);
    }

    @Test
    void shouldBeReadFromAnyPlaceAcrossItsParts() throws IOException {
        ByteBuffer middle =
                ByteBuffer.wrap(new byte[] {9, 9, 3, 4, (byte) 255, 9}).position(2);
        List<ByteBuffer> parts = List.of(
                ByteBuffer.wrap(new byte[] {1, 2}),
                ByteBuffer.allocate(0),
                middle.limit(5).slice());
        EncodedArchive archive = new EncodedArchive(parts, null, List.of());
        byte[] all = {1, 2, 3, 4, (byte) 255};
        for (int from = 0; from <= all.length; from++) {
            InputStream in = archive.open();
            in.skipNBytes(from);
            assertThat(in.readAllBytes()).isEqualTo(java.util.Arrays.copyOfRange(all, from, all.length));
            assertThat(in.read()).isEqualTo(-1);
            assertThat(in.skip(1)).isZero();
        }
        InputStream single = archive.open();
        for (byte b : all) assertThat(single.read()).isEqualTo(b & 0xff);
    }

    @Test
    void shouldWriteMoreThanAnArrayHoldsAndSaySoWhereOneIsWanted() throws IOException {
        EncodedArchive archive = new EncodedArchive(huge.parts(), null, List.of());
        long[] written = {0};
        byte[][] last = {null};
        archive.writeTo(new OutputStream() {
            @Override
            public void write(int b) {
                throw new AssertionError("byte by byte");
            }

            @Override
            public void write(byte[] bytes, int offset, int length) {
                written[0] += length;
                if (length != 4) last[0] = java.util.Arrays.copyOfRange(bytes, offset, offset + length);
            }
        });
        assertThat(written[0]).isEqualTo(archive.length()).isGreaterThan(1L << 31);
        assertThat(last[0]).isEqualTo(HugeArchive.POSTER);
        InputStream in = archive.open();
        in.skipNBytes(archive.length() - 1);
        assertThat(in.readAllBytes()).hasSize(1);
        assertThatThrownBy(archive::bytes)
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining(archive.length() + " bytes")
                .hasMessageContaining("writeTo");
    }

    @Test
    void shouldIndexBatchesBeyondTwoGibibytes() throws IOException {
        ArchiveDecoder decoder = new ArchiveDecoder();
        for (int i = 0; decoder.header() == null; i++) {
            ByteBuffer part = huge.parts().get(i);
            decoder.feed(part.array(), part.arrayOffset() + part.position(), part.remaining());
        }
        ArchiveHeader header = decoder.header();
        BatchIndex index = header.batches();
        assertThat(index.archiveBytes()).isEqualTo(huge.length()).isGreaterThan(1L << 31);
        assertThat(index.offset(index.poster())).isGreaterThan(1L << 31);
        assertThat(header.images().stream().mapToLong(i -> i.bytes()).sum()).isGreaterThan(1L << 31);
    }
}
