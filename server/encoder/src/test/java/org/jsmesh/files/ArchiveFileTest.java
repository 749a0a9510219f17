package org.jsmesh.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileTime;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.encode.write.HugeArchive;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.io.ByteSource;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Archives that are larger than an array can be. */
class ArchiveFileTest {
    private static final long TWO_GIBIBYTES = 1L << 31;
    private static final Mesh TETRAHEDRON = new MeshBuilder()
            .positions(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1})
            .faceWedges(new int[] {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2})
            .build();

    @TempDir
    private Path folder;

    private static HugeArchive huge;

    @BeforeAll
    static void makeHuge() throws IOException {
        huge = HugeArchive.of(TETRAHEDRON);
    }

    @Test
    void shouldReadWhatLiesBehindTwoGibibytes() throws IOException {
        ArchiveFile archive = ArchiveFile.of(stored(huge.length()));
        assertThat(archive.isWhole()).isTrue();
        assertThat(archive.length()).isEqualTo(huge.length()).isGreaterThan(TWO_GIBIBYTES);
        assertThat(archive.poster()).isEqualTo(HugeArchive.POSTER);
        assertThat(archive.meshAfter(0, ProgressListener.NONE).faces()).isEqualTo(TETRAHEDRON.faces());
    }

    @Test
    void shouldTellWhereAFileIsCutBehindTwoGibibytes() throws IOException {
        ArchiveFile archive = ArchiveFile.of(stored(huge.length() - 1));
        BatchIndex index = archive.index();
        assertThat(archive.isWhole()).isFalse();
        assertThat(archive.batches()).isEqualTo(index.size() - 1);
        assertThat(archive.poster()).isNull();
        assertThatThrownBy(() -> archive.original(ProgressListener.NONE))
                .isInstanceOf(MalformedStreamException.class)
                .hasMessageContaining((index.size() - 1) + " of " + index.size() + " batches")
                .hasMessageContaining("byte " + (huge.length() - 1));
    }

    private static ByteSource stored(long length) {
        return new ByteSource() {
            @Override
            public long length() {
                return length;
            }

            @Override
            public InputStream from(long offset) {
                return huge.from(offset);
            }
        };
    }

    @Test
    void shouldRefuseALargeFileThatWasChangedSinceItWasOpened() throws IOException {
        Path file = folder.resolve("a.bin");
        Files.write(file, new byte[100]);
        FileSource bytes = FileSource.of(file);
        try (InputStream in = bytes.from(40)) {
            assertThat(in.readAllBytes()).hasSize(60);
        }
        Files.setLastModifiedTime(file, FileTime.fromMillis(1));
        assertThatThrownBy(() -> bytes.from(0)).isInstanceOf(IOException.class).hasMessageContaining("was changed");
    }

    @Test
    @Tag("long") // more than 2 GiB on disk
    void shouldReadAFileOfMoreThanTwoGibibytes() throws IOException {
        Path file = folder.resolve("huge.jsm");
        try (FileChannel out = FileChannel.open(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE)) {
            for (ByteBuffer part : huge.parts()) {
                ByteBuffer rest = part.duplicate();
                while (rest.hasRemaining()) out.write(rest);
            }
        }
        ArchiveFile archive = ArchiveFile.read(file);
        assertThat(archive.poster()).isEqualTo(HugeArchive.POSTER);
        ArchiveReport report = archive.report();
        assertThat(report.bytes()).isEqualTo(Files.size(file)).isGreaterThan(TWO_GIBIBYTES);
        try (InputStream in = huge.from(0)) {
            assertThat(report.archiveSha256()).isEqualTo(Hashes.sha256(in));
        }
        assertThat(report.batches().get(report.batches().size() - 1).offset()).isGreaterThan(TWO_GIBIBYTES);
    }
}
