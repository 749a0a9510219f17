package org.jsmesh.archive;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.lifecycle.AddLifecycleHook;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshCleaner;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.Note;
import org.jsmesh.test.FewerTries;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

@AddLifecycleHook(FewerTries.class)
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

    @Property(tries = 100, seed = "20022")
    void shouldGiveBackAnyMeshWithLightPredictors(
            @ForAll RandomMeshes kind, @ForAll @IntRange(max = 1_000_000) int seed) throws Exception {
        Mesh mesh = kind.mesh(seed);
        EncodedArchive archive = TestArchives.encodeLightly(mesh);
        assertThat(MeshIdentity.sha256(TestArchives.mesh(archive.bytes())))
                .isEqualTo(MeshIdentity.sha256(mesh))
                .isEqualTo(archive.header().meshSha256());
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
