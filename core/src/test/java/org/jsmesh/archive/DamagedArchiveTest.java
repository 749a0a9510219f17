package org.jsmesh.archive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.ConcurrentHashMap;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshComparison;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.test.FastSet;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class DamagedArchiveTest {
    /** For at most 420 bytes. */
    private static final long RANDOM_BYTES_MOST = 4 << 20;

    private static final Map<String, byte[]> ARCHIVES = new ConcurrentHashMap<>();

    /** Made once, as encoding takes far longer than decoding; in the fast set, from one mesh of each kind. */
    private static byte[] archive(RandomMeshes kind, int seed) {
        int chosen = FastSet.choose(5, seed);
        return ARCHIVES.computeIfAbsent(
                kind + " " + chosen,
                key -> TestArchives.encodeFar(kind.mesh(chosen)).bytes());
    }

    @ParameterizedTest
    @EnumSource
    void shouldShowAShorterMeshWhenTruncated(RandomMeshes kind) throws Exception {
        byte[] bytes = archive(kind, 3);
        for (int length = 0; length < bytes.length; length += FastSet.choose(37, 3)) {
            ArchiveDecoder decoder = TestArchives.decode(bytes, length);
            assertThat(decoder.isComplete()).isFalse();
            assertThat(decoder.received()).isEqualTo(length);
            if (decoder.batches() > 0)
                assertThat(decoder.index().end(decoder.batches() - 1)).isLessThanOrEqualTo(length);
        }
    }

    @ParameterizedTest
    @EnumSource
    void shouldNoticeAFlippedBit(RandomMeshes kind) {
        byte[] bytes = archive(kind, 4);
        for (int bit = 0; bit < 8 * bytes.length; bit += FastSet.choose(301, 11)) {
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

    /**
     * With its checksums mended, damage reaches the decoder proper: it may decode to something, but never to a false
     * proof.
     */
    @ParameterizedTest
    @EnumSource
    void shouldSurviveDamageBehindValidChecksums(RandomMeshes kind) throws Exception {
        byte[] bytes = archive(kind, 5);
        Mesh original = TestArchives.mesh(bytes);
        String identity = TestArchives.decode(bytes, bytes.length).header().meshSha256();
        Random random = new Random(6);
        for (int i = 0; i < FastSet.choose(60, 300); i++) {
            byte[] damaged = bytes.clone();
            for (int k = 1 + random.nextInt(3); k > 0; k--)
                damaged[6 + random.nextInt(bytes.length - 6)] = (byte) random.nextInt();
            Checksums.mend(
                    damaged, TestArchives.decode(bytes, bytes.length).header().batches());
            ArchiveDecoder decoder = new ArchiveDecoder();
            try {
                decoder.feed(damaged, 0, damaged.length);
            } catch (MalformedStreamException e) {
                assertThat(e.getMessage()).isNotBlank();
            }
            if (decoder.batches() == 0) continue;
            Mesh mesh = decoder.mesh();
            if (MeshIdentity.sha256(mesh).equals(identity)) // the damage hit spare bits only
            assertThat(MeshComparison.firstDifference(original, mesh)).isEmpty();
        }
    }

    /**
     * What an honest archive of the same claims takes is the measure: the damaged one may take up to four times that.
     */
    @ParameterizedTest
    @EnumSource
    void shouldNotTakeMoreMemoryThanTheArchiveClaims(RandomMeshes kind) throws Exception {
        byte[] bytes = archive(kind, 5);
        BatchIndex index = TestArchives.decode(bytes, bytes.length).header().batches();
        long honest = allocated(bytes);
        int body = (int) index.offset(0) + index.bytes(0) - 1;
        Random random = new Random(7);
        for (int i = 0; i < FastSet.choose(20, 100); i++) {
            byte[] damaged = bytes.clone();
            for (int k = 0; k < 3; k++) damaged[body + random.nextInt(bytes.length - body)] = (byte) random.nextInt();
            Checksums.mend(damaged, index);
            assertThat(Math.min(allocated(damaged), allocated(damaged))).isLessThan(4 * honest);
        }
    }

    /** Bytes that start like an archive and go on at random, their header's checksum right: whatever they claim. */
    @Test
    void shouldNotTakeMuchMemoryForRandomBytes() {
        Random random = new Random(8);
        for (int i = 0; i < 2000; i++) {
            byte[] bytes = new byte[21 + random.nextInt(400)];
            random.nextBytes(bytes);
            if (i % 4 > 0) Checksums.pretend(bytes, random.nextInt(bytes.length - 17));
            assertThat(Math.min(allocated(bytes), allocated(bytes))).isLessThan(RANDOM_BYTES_MOST);
        }
    }

    /** Bytes allocated by decoding, whether it succeeds or not. The first time the JVM itself may allocate more. */
    private static long allocated(byte[] archive) {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = threads.getCurrentThreadAllocatedBytes();
        try {
            new ArchiveDecoder().feed(archive, 0, archive.length);
        } catch (MalformedStreamException e) {
            assertThat(e.getMessage()).isNotBlank();
        }
        return threads.getCurrentThreadAllocatedBytes() - before;
    }

    @ParameterizedTest
    @EnumSource
    void shouldRefuseBytesAfterTheEnd(RandomMeshes kind) throws Exception {
        byte[] bytes = archive(kind, 5);
        ArchiveDecoder decoder = TestArchives.decode(bytes, bytes.length);
        assertThatThrownBy(() -> decoder.feed(new byte[1], 0, 1))
                .isInstanceOf(MalformedStreamException.class)
                .hasMessageContaining("after the last batch");
    }
}
