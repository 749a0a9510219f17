package org.jsmesh.store.bucket;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.jsmesh.objects.FolderObjectStore;
import org.jsmesh.store.ModelUnavailableException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Archives of a site, their blocks, and those who read them. */
@Timeout(60)
class BlocksTest {
    private static final int BLOCK = TestSites.BLOCK_BYTES;

    @TempDir
    private Path folder;

    @TempDir
    private Path scratch;

    private final AtomicLong nanos = new AtomicLong();
    private final Reads reads = new Reads("s3://bucket", 30_000);
    private FaultyStore store;
    private BlockCache blocks;
    private SiteArchives archives;
    private byte[] content;
    private String sha256;
    private String key;

    @BeforeEach
    void publish() throws Exception {
        content = TestSites.archive(scratch);
        sha256 = TestSites.publish(folder, "chair", content);
        key = "m/chair/" + sha256 + ".jsm";
        store = new FaultyStore(new FolderObjectStore(folder));
    }

    @AfterEach
    void stop() {
        reads.close();
    }

    private SiteArchive open(int mostBlocks) {
        blocks = new BlockCache(store, reads, (long) mostBlocks * BLOCK, BLOCK);
        archives = new SiteArchives(store, reads, blocks, nanos::get);
        return archives.open(key, sha256).join();
    }

    @Test
    void shouldForgetBlocksThatWereUsedLongestAgo() {
        SiteArchive archive = open(2);
        for (int block : List.of(3, 4, 3, 5)) blocks.get(archive, block).join();
        assertThat(blocks.known(archive, 3)).isNotNull();
        assertThat(blocks.known(archive, 4)).isNull();
        assertThat(blocks.known(archive, 5)).isNotNull();
        assertThat(blocks.keptBytes()).isEqualTo(2 * BLOCK);
        int before = store.reads.get();
        assertThat(blocks.get(archive, 5).join()).hasSize(BLOCK);
        assertThat(store.reads).hasValue(before);
    }

    @Test
    void shouldReadABlockOnceForAllWhoAskMeanwhile() {
        SiteArchive archive = open(8);
        store.hang();
        assertThat(blocks.get(archive, 6)).isSameAs(blocks.get(archive, 6));
        store.release();
        blocks.get(archive, 6).join();
        assertThat(blocks.known(archive, 6)).isDone();
    }

    @Test
    void shouldOpenAnewWhatWasReplaced() throws Exception {
        SiteArchive archive = open(2);
        byte[] other = content.clone();
        other[other.length - 1] ^= 1;
        Path file = folder.resolve(key);
        Path beside = Files.write(folder.resolve("other"), other);
        Files.delete(file);
        Files.move(beside, file);
        assertThat(archives.open(key, sha256).join()).isSameAs(archive);
        assertThatThrownBy(() -> blocks.get(archive, 5).join()).hasCauseInstanceOf(ModelUnavailableException.class);
        assertThat(archive.isLost()).isTrue();
        assertThat(archives.recent(key)).isNull();
        SiteArchive next = archives.open(key, sha256).join();
        assertThat(next).isNotSameAs(archive);
        assertThat(next.isLost()).isFalse();
        assertThat(next.read(other.length - 1, 1).join()).containsExactly(other[other.length - 1]);
    }

    @Test
    void shouldRememberForAMomentThatThereIsNone() {
        open(2);
        String absent = "m/chair/" + "a".repeat(64) + ".jsm";
        int before = store.finds.get();
        assertThat(archives.open(absent, "a".repeat(64)).join()).isNull();
        nanos.addAndGet(TimeUnit.SECONDS.toNanos(3));
        assertThat(archives.open(absent, "a".repeat(64)).join()).isNull();
        assertThat(store.finds).hasValue(before + 1);
        nanos.addAndGet(TimeUnit.SECONDS.toNanos(3));
        assertThat(archives.open(absent, "a".repeat(64)).join()).isNull();
        assertThat(store.finds).hasValue(before + 2);
    }

    @Test
    void shouldFindNothingUnderAKeyThatNoObjectHas() {
        open(2);
        int before = store.finds.get();
        assertThat(archives.open("m/" + "x".repeat(2000) + "/a.jsm", sha256).join())
                .isNull();
        assertThat(archives.open("m/../a.jsm", sha256).join()).isNull();
        assertThat(store.finds).hasValue(before);
    }

    /** Two take turns, and there is room for one block alone. */
    @Test
    void shouldReadNoByteOftenForReadersWhoAreSlow() throws Exception {
        SiteArchive archive = open(1);
        long before = blocks.readBytes();
        int portion = BLOCK / 8;
        BlockReader first = new BlockReader(archive, portion);
        BlockReader second = new BlockReader(archive, portion);
        long half = (content.length / 2 / BLOCK) * (long) BLOCK;
        ByteArrayOutputStream firstGot = new ByteArrayOutputStream();
        ByteArrayOutputStream secondGot = new ByteArrayOutputStream();
        while (firstGot.size() < half) {
            take(first, firstGot, 0, half);
            take(second, secondGot, half, half);
        }
        first.close();
        second.abandon();
        assertThat(firstGot.toByteArray()).isEqualTo(Arrays.copyOf(content, (int) half));
        assertThat(secondGot.toByteArray()).isEqualTo(Arrays.copyOfRange(content, (int) half, (int) (2 * half)));
        assertThat(blocks.readBytes() - before).isBetween(2 * half, 4 * half);
    }

    private static void take(BlockReader reader, ByteArrayOutputStream got, long from, long length) throws Exception {
        long left = length - got.size();
        reader.ready(from + got.size(), left).get();
        ByteBuffer bytes = reader.next(from + got.size(), left);
        got.write(bytes.array(), bytes.position(), bytes.remaining());
    }

    @Test
    void shouldReadAheadOnlyWhereThereIsRoom() throws Exception {
        for (int mostBlocks : new int[] {1, 64}) {
            SiteArchive archive = open(mostBlocks);
            try (BlockReader reader = new BlockReader(archive, content.length)) {
                ByteArrayOutputStream got = new ByteArrayOutputStream();
                while (got.size() < 4 * BLOCK) take(reader, got, 0, content.length);
                boolean isAhead = blocks.known(archive, got.size() / BLOCK) != null;
                assertThat(isAhead).isEqualTo(mostBlocks > 1);
            }
        }
    }

    @Test
    void shouldGiveRoomBackWhenReadersEnd() {
        SiteArchive archive = open(8);
        assertThat(blocks.room()).isEqualTo(7);
        BlockReader first = new BlockReader(archive, 1);
        BlockReader second = new BlockReader(archive, 1);
        assertThat(blocks.room()).isEqualTo(3);
        first.close();
        first.abandon();
        assertThat(blocks.room()).isEqualTo(7);
        second.abandon();
        assertThat(blocks.room()).isEqualTo(7);
    }
}
