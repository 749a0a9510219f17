package org.jsmesh.archive;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshCleaner;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.Note;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class RoundTripTest {
    @Property(tries = 300, seed = "20021")
    void shouldGiveBackAnyMeshExactly(@ForAll RandomMeshes kind, @ForAll @IntRange(max = 1_000_000) int seed)
            throws Exception {
        Mesh mesh = kind.mesh(seed);
        EncodedArchive archive = TestArchives.encodeFar(mesh);
        Mesh decoded = TestArchives.mesh(archive.bytes());
        assertThat(MeshIdentity.sha256(decoded))
                .isEqualTo(MeshIdentity.sha256(mesh))
                .isEqualTo(archive.header().meshSha256());
        assertThat(decoded.faces())
                .isEqualTo(mesh.faces())
                .isEqualTo(archive.header().faces());
        assertThat(decoded.vertices()).isEqualTo(archive.header().vertices());
    }

    @Property(tries = 200, seed = "20023")
    void shouldGiveBackAnyMeshThatThePaperSimplified(
            @ForAll RandomMeshes kind, @ForAll @IntRange(max = 1_000_000) int seed) throws Exception {
        Mesh mesh = kind.mesh(seed);
        byte[] bytes = TestArchives.encodeByPaper(mesh).bytes();
        ArchiveDecoder decoder = TestArchives.decode(bytes, bytes.length);
        assertThat(MeshIdentity.sha256(decoder.mesh())).isEqualTo(MeshIdentity.sha256(mesh));
        BatchIndex index = decoder.header().batches();
        assertThat(index.precisionBits(0)).isEqualTo(32);
        for (int level = 1; level <= decoder.header().levels().size(); level++) {
            int last = 0;
            for (int b = 0; b < index.size(); b++) if (index.level(b) == level) last = b;
            assertThat(last).as("a batch ends level %d", level).isPositive();
        }
    }

    @Property(tries = 60, seed = "20022")
    void shouldShowAMeshAfterEveryBatchThatMatchesItsIndex(
            @ForAll RandomMeshes kind, @ForAll @IntRange(max = 1_000_000) int seed) throws Exception {
        byte[] bytes = TestArchives.encodeFar(kind.mesh(seed)).bytes();
        ArchiveDecoder decoder = new ArchiveDecoder();
        int seen = 0;
        for (int i = 0; i < bytes.length; i++) { // byte by byte
            decoder.feed(bytes, i, 1);
            if (decoder.batches() == seen) continue;
            BatchIndex index = decoder.header().batches();
            assertThat(decoder.batches()).isEqualTo(seen + 1);
            assertThat(index.end(seen)).isEqualTo(i + 1);
            Mesh shown = decoder.mesh();
            assertThat(shown.faces()).isEqualTo(index.faces(seen));
            assertThat(shown.vertices()).isEqualTo(index.vertices(seen));
            if (seen > 0) {
                assertThat(index.faces(seen)).isGreaterThanOrEqualTo(index.faces(seen - 1));
                assertThat(index.errorMean(seen)).isLessThanOrEqualTo(index.errorMean(seen - 1));
            }
            seen++;
        }
        assertThat(decoder.isComplete()).isTrue();
        assertThat(decoder.header().batches().archiveBytes()).isEqualTo(bytes.length);
    }

    @ParameterizedTest
    @EnumSource
    void shouldKeepVertexAndWedgeCounts(RandomMeshes kind) throws Exception {
        Mesh clean = MeshCleaner.clean(kind.mesh(7), new java.util.ArrayList<>());
        Mesh decoded = TestArchives.mesh(TestArchives.encodeFar(clean).bytes());
        assertThat(decoded.vertices()).isEqualTo(clean.vertices());
        assertThat(decoded.materials()).isEqualTo(clean.materials());
    }

    @Test
    void shouldKeepNegativeZeroDenormalsAndExtremes() throws Exception {
        float[] odd = {
            -0f,
            0f,
            Float.MIN_VALUE,
            -Float.MIN_VALUE,
            Float.MAX_VALUE,
            -Float.MAX_VALUE,
            1e-38f,
            3.4e38f,
            .1f,
            1f / 3,
            -1e-20f,
            16777217f
        };
        float[] positions = new float[36];
        for (int i = 0; i < 36; i++) positions[i] = odd[(i * 5 + i / 12) % 12];
        int[] faces = new int[30];
        for (int f = 0; f < 10; f++) for (int j = 0; j < 3; j++) faces[3 * f + j] = f + j;
        Mesh mesh = new MeshBuilder().positions(positions).faceWedges(faces).build();
        assertThat(MeshIdentity.sha256(
                        TestArchives.mesh(TestArchives.encode(mesh).bytes())))
                .isEqualTo(MeshIdentity.sha256(mesh));
    }

    @Test
    void shouldRefuseAMeshWithoutFaces() {
        Mesh empty =
                new MeshBuilder().positions(new float[9]).materials(List.of()).build();
        org.assertj.core.api.Assertions.assertThatIllegalArgumentException()
                .isThrownBy(() -> TestArchives.encode(empty))
                .withMessageContaining("no faces");
    }

    @Test
    void shouldReportVerticesThatNoFaceUses() {
        Mesh mesh = new MeshBuilder()
                .positions(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 5, 5})
                .faceWedges(new int[] {0, 1, 2})
                .build();
        EncodedArchive archive = TestArchives.encode(mesh);
        assertThat(archive.notes())
                .containsExactly(Note.dropped("1 vertex that no face refers to dropped.", 1, "vertex 3"));
        assertThat(archive.header().vertices()).isEqualTo(3);
    }
}
