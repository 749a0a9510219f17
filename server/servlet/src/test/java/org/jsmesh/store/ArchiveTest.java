package org.jsmesh.store;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.jsmesh.mesh.MalformedStreamException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ArchiveTest {
    private static final byte[] FILE = TestArchives.of(3, 300, 2000, 796);

    @TempDir
    Path folder;

    @Test
    void shouldGiveViewsOfTheMappedFile() throws IOException {
        Archive archive = Archive.open(file(FILE), TestArchives.READER);
        ByteBuffer view = archive.slice(300, 2000);
        assertThat(view.isDirect()).isTrue();
        assertThat(view.isReadOnly()).isTrue();
        assertThat(view.remaining()).isEqualTo(2000);
        assertThat(archive.slice(FILE.length, 0).hasRemaining()).isFalse();
    }

    @Test
    void shouldGoOnBehindTheBorderOfASegment() throws IOException {
        Archive archive = Archive.open(file(FILE), TestArchives.READER, 10);
        String sha256 = Archive.open(file(FILE), TestArchives.READER).sha256();
        assertThat(archive.sha256()).isEqualTo(sha256);
        assertThat(archive.slice(1000, 2000).remaining()).isEqualTo(24);
        assertThat(bytes(archive, 0, FILE.length)).isEqualTo(FILE);
        assertThat(bytes(archive, 1000, 1100)).isEqualTo(Arrays.copyOfRange(FILE, 1000, 2100));
        assertThat(bytes(archive, 1024, 1024)).isEqualTo(Arrays.copyOfRange(FILE, 1024, 2048));
        assertThat(bytes(archive, 3000, 96)).isEqualTo(Arrays.copyOfRange(FILE, 3000, 3096));
    }

    @Test
    void shouldRefuseBytesOutsideOfTheFile() throws IOException {
        Archive archive = Archive.open(file(FILE), TestArchives.READER);
        assertThatThrownBy(() -> archive.slice(-1, 2)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> archive.slice(3000, 97)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> archive.slice(0, -1)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void shouldRefuseFilesThatAreNoArchive() {
        for (byte[] bytes : new byte[][] {{}, {1, 2, 3}, "ply ascii".getBytes(StandardCharsets.US_ASCII)}) {
            assertThatThrownBy(() -> Archive.open(file(bytes), HeaderReader.DECODER))
                    .isInstanceOf(MalformedStreamException.class);
        }
    }

    static byte[] bytes(Archive archive, long offset, long length) {
        byte[] bytes = new byte[(int) length];
        for (int at = 0; at < length; ) {
            ByteBuffer slice = archive.slice(offset + at, length - at);
            int count = slice.remaining();
            slice.get(bytes, at, count);
            at += count;
        }
        return bytes;
    }

    private Path file(byte[] bytes) throws IOException {
        return Files.write(folder.resolve("file.jsm"), bytes);
    }
}
