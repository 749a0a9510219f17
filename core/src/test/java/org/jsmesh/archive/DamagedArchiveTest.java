package org.jsmesh.archive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Random;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class DamagedArchiveTest {
    @ParameterizedTest
    @EnumSource
    void shouldShowAShorterMeshWhenTruncated(RandomMeshes kind) throws Exception {
        byte[] bytes = Archives.encodeFar(kind.mesh(3)).bytes();
        for (int length = 0; length < bytes.length; length++) {
            ArchiveDecoder decoder = Archives.decode(bytes, length);
            assertThat(decoder.isComplete()).isFalse();
            assertThat(decoder.received()).isEqualTo(length);
            if (decoder.batches() > 0)
                assertThat(decoder.header().batches().end(decoder.batches() - 1))
                        .isLessThanOrEqualTo(length);
        }
    }

    @ParameterizedTest
    @EnumSource
    void shouldNoticeEveryFlippedBit(RandomMeshes kind) {
        byte[] bytes = Archives.encodeFar(kind.mesh(4)).bytes();
        for (int bit = 0; bit < 8 * bytes.length; bit += 3) {
            byte[] damaged = bytes.clone();
            damaged[bit >> 3] ^= (byte) (1 << (bit & 7));
            assertNeverComplete(damaged, "bit " + bit);
        }
    }

    private static void assertNeverComplete(byte[] damaged, String what) {
        ArchiveDecoder decoder = new ArchiveDecoder();
        try {
            decoder.feed(damaged, 0, damaged.length);
            assertThat(decoder.isComplete()).as(what).isFalse(); // a length that grew: the decoder waits for more
        } catch (MalformedStreamException e) {
            assertThat(e.offset()).as(what).isBetween(0L, (long) damaged.length);
            assertThatThrownBy(() -> decoder.feed(damaged, 0, 1))
                    .as(what + ", fed on")
                    .isSameAs(e);
        }
    }

    /** With its checksums mended, damage reaches the decoder proper: it may decode to something, but never to a false proof. */
    @ParameterizedTest
    @EnumSource
    void shouldSurviveDamageBehindValidChecksums(RandomMeshes kind) throws Exception {
        byte[] bytes = Archives.encodeFar(kind.mesh(5)).bytes();
        String identity = Archives.decode(bytes, bytes.length).header().meshSha256();
        Random random = new Random(6);
        for (int i = 0; i < 300; i++) {
            byte[] damaged = bytes.clone();
            for (int k = 1 + random.nextInt(3); k > 0; k--)
                damaged[12 + random.nextInt(bytes.length - 12)] = (byte) random.nextInt();
            Checksums.mend(
                    damaged, Archives.decode(bytes, bytes.length).header().batches());
            ArchiveDecoder decoder = new ArchiveDecoder();
            try {
                decoder.feed(damaged, 0, damaged.length);
            } catch (MalformedStreamException e) {
                assertThat(e.getMessage()).isNotBlank();
            }
            if (decoder.batches() == 0) continue;
            Mesh mesh = decoder.mesh();
            if (!java.util.Arrays.equals(damaged, bytes)
                    && MeshIdentity.sha256(mesh).equals(identity)) {
                assertThat(MeshIdentity.sha256(Archives.mesh(bytes))).isEqualTo(identity); // damage in spare bits only
            }
        }
    }

    @ParameterizedTest
    @EnumSource
    void shouldRefuseBytesAfterTheEnd(RandomMeshes kind) throws Exception {
        byte[] bytes = Archives.encodeFar(kind.mesh(8)).bytes();
        ArchiveDecoder decoder = Archives.decode(bytes, bytes.length);
        assertThatThrownBy(() -> decoder.feed(new byte[1], 0, 1))
                .isInstanceOf(MalformedStreamException.class)
                .hasMessageContaining("after the last batch");
    }
}
