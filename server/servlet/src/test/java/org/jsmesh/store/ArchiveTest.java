package org.jsmesh.store;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.servlet.http.Digests;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ArchiveTest {
    private static final byte[] FILE = TestArchives.of(3, 300, 2000, 796);
    private static final byte[] LARGE = TestArchives.of(4, 300, 100_000, 7);

    @TempDir
    Path folder;

    @Test
    void shouldGiveTheBytesOfTheFile() throws IOException {
        try (Archive archive = Archive.open(file(LARGE), TestArchives.READER)) {
            assertThat(archive.sha256()).isEqualTo(Digests.sha256(LARGE));
            Random random = new Random(5);
            for (int i = 0; i < 200; i++) {
                int from = random.nextInt(LARGE.length + 1);
                int length = random.nextInt(LARGE.length - from + 1);
                assertThat(archive.copy(from, length)).isEqualTo(Arrays.copyOfRange(LARGE, from, from + length));
            }
        }
    }

    @Test
    void shouldGiveABlockAtATime() throws IOException {
        try (Archive archive = Archive.open(file(LARGE), TestArchives.READER);
                ArchiveReader reader = archive.reader(1)) {
            assertThat(reader.next(Archive.BLOCK_BYTES - 24, 2000).remaining()).isEqualTo(24);
            assertThat(reader.next(Archive.BLOCK_BYTES, 2000).remaining()).isEqualTo(2000);
            assertThat(reader.next(LARGE.length - 3, 3).remaining()).isEqualTo(3);
            assertThat(reader.next(0, LARGE.length).isDirect()).isTrue();
        }
    }

    @Test
    void shouldGiveManyBlocksAtATimeForLongAnswers() throws IOException {
        byte[] file = TestArchives.of(5, 300, 1_000_000, 7);
        try (Archive archive = Archive.open(file(file), TestArchives.READER);
                ArchiveReader reader = archive.reader(file.length)) {
            int most = 0;
            for (int at = 11; at < file.length; ) {
                ByteBuffer portion = reader.next(at, file.length - at);
                byte[] bytes = new byte[portion.remaining()];
                portion.get(bytes);
                assertThat(bytes).isEqualTo(Arrays.copyOfRange(file, at, at + bytes.length));
                at += bytes.length;
                most = Math.max(most, bytes.length);
            }
            assertThat(most).isEqualTo(8 * Archive.BLOCK_BYTES);
        }
    }

    @Test
    void shouldRefuseBytesOutsideOfTheFile() throws IOException {
        try (Archive archive = Archive.open(file(FILE), TestArchives.READER);
                ArchiveReader reader = archive.reader(1)) {
            assertThatThrownBy(() -> reader.next(-1, 2)).isInstanceOf(IllegalArgumentException.class);
            assertThatThrownBy(() -> reader.next(3000, 97)).isInstanceOf(IllegalArgumentException.class);
            assertThatThrownBy(() -> archive.copy(0, -1)).isInstanceOf(IllegalArgumentException.class);
        }
    }

    @Test
    void shouldNeverGiveOtherBytesThanItHashed() throws IOException {
        Path file = file(LARGE);
        try (Archive archive = Archive.open(file, TestArchives.READER)) {
            byte[] altered = LARGE.clone();
            altered[Archive.BLOCK_BYTES + 5] ^= 1;
            Files.write(file, altered);
            assertThat(archive.copy(0, 1000)).isEqualTo(Arrays.copyOf(LARGE, 1000));
            assertThat(archive.isBroken()).isFalse();
            assertThatThrownBy(() -> archive.copy(Archive.BLOCK_BYTES, 1)).hasMessageContaining("written into");
            assertThat(archive.isBroken()).isTrue();
        }
    }

    @Test
    void shouldSayThatTheFileWasCut() throws IOException {
        Path file = file(LARGE);
        try (Archive archive = Archive.open(file, TestArchives.READER)) {
            Files.write(file, Arrays.copyOf(LARGE, 1000));
            assertThatThrownBy(() -> archive.copy(2 * Archive.BLOCK_BYTES, 10))
                    .isInstanceOf(IOException.class)
                    .hasMessageContaining("was cut");
            assertThat(archive.isBroken()).isTrue();
        }
    }

    @Test
    void shouldStayOpenForThoseWhoRead() throws IOException {
        Archive archive = Archive.open(file(FILE), TestArchives.READER);
        ArchiveReader reader = archive.reader(1);
        archive.close();
        archive.close();
        assertThat(archive.isInUse()).isTrue();
        assertThat(archive.reader(1)).isNull();
        assertThat(reader.next(7, 1).get()).isEqualTo(FILE[7]);
        reader.close();
        reader.close();
        assertThat(archive.isInUse()).isFalse();
        assertThatThrownBy(() -> archive.copy(0, 1)).hasMessageContaining("closed");
    }

    @Test
    void shouldRefuseFilesThatAreNoArchive() {
        for (byte[] bytes : new byte[][] {{}, {1, 2, 3}, "ply ascii".getBytes(StandardCharsets.US_ASCII)}) {
            assertThatThrownBy(() -> Archive.open(file(bytes), HeaderReader.DECODER))
                    .isInstanceOf(MalformedStreamException.class);
        }
    }

    private Path file(byte[] bytes) throws IOException {
        return Files.write(folder.resolve("file.jsm"), bytes);
    }
}
