package org.jsmesh.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class MeshCleanerTest {
    private static final float[] POINTS = {0, 0, 0, 1, 0, 0, 0, 1, 0, 9, 9, 9};

    @ParameterizedTest
    @EnumSource
    void shouldReturnAMeshThatIsCleanAsItIs(RandomMeshes kind) {
        Mesh clean = MeshCleaner.clean(kind.mesh(5), new ArrayList<>());
        assertThat(MeshCleaner.clean(clean, new ArrayList<>())).isSameAs(clean);
    }

    @Test
    void shouldDropWhatNoFaceRefersTo() {
        List<Note> notes = new ArrayList<>();
        Mesh mesh = new MeshBuilder()
                .positions(POINTS)
                .faceWedges(new int[] {2, 1, 0})
                .build();
        Mesh clean = MeshCleaner.clean(mesh, notes);
        assertThat(clean.positions()).containsExactly(0, 0, 0, 1, 0, 0, 0, 1, 0);
        assertThat(clean.faceWedges()).containsExactly(2, 1, 0);
        assertThat(notes).containsExactly(Note.dropped("1 vertex that no face refers to dropped.", 1, "vertex 3"));
    }

    @Test
    void shouldMergeWedgesThatHaveNothingOfTheirOwn() {
        Mesh mesh = new MeshBuilder()
                .positions(POINTS)
                .wedgeVertices(new int[] {0, 1, 2, 3, 0})
                .faceWedges(new int[] {0, 1, 2, 4, 2, 3})
                .build();
        Mesh clean = MeshCleaner.clean(mesh, new ArrayList<>());
        assertThat(clean.wedges()).isEqualTo(4);
        assertThat(clean.faceWedges()).containsExactly(0, 1, 2, 0, 2, 3);
    }
}
