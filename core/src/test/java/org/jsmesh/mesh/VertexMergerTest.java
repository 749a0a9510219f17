package org.jsmesh.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class VertexMergerTest {
    private final List<Note> notes = new ArrayList<>();

    @ParameterizedTest
    @EnumSource(RandomMeshes.class)
    void shouldJoinFacesThatWereTakenApart(RandomMeshes kind) {
        Mesh mesh = MeshCleaner.clean(kind.mesh(11), new ArrayList<>());
        Mesh merged = VertexMerger.merge(apart(mesh), notes);
        assertThat(MeshIdentity.sha256(MeshCleaner.clean(merged, notes))).isEqualTo(MeshIdentity.sha256(mesh));
        if (isApart(mesh)) assertThat(fans(merged)).isLessThanOrEqualTo(fans(mesh));
    }

    /** Whether no two vertices lie at the same place, where nobody could tell whose a face was. */
    private static boolean isApart(Mesh mesh) {
        TupleTable places = new TupleTable(3, mesh.vertices());
        int[] bits = new int[3 * mesh.vertices()];
        for (int i = 0; i < bits.length; i++) bits[i] = Float.floatToRawIntBits(mesh.positions()[i]);
        for (int v = 0; v < mesh.vertices(); v++) places.intern(bits, 3 * v);
        return places.size() == mesh.vertices();
    }

    @Test
    void shouldSayHowManyVerticesItMerged() {
        Mesh square = new MeshBuilder()
                .positions(new float[] {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 1, 0})
                .faceWedges(new int[] {0, 1, 2, 3, 4, 5})
                .build();
        assertThat(fans(VertexMerger.merge(square, notes))).isEqualTo(4);
        // 6 is in no face
        assertThat(notes)
                .containsExactly(Note.repaired("2 vertices merged with others at the same position.", 2, "vertex 3"));
    }

    @Test
    void shouldLeaveTheTwoSidesOfASheetApart() {
        Mesh front = RandomMeshes.FLAT_GRID.mesh(4);
        int n = front.vertices();
        float[] positions = new float[6 * n];
        int[] faces = new int[2 * front.faceWedges().length];
        for (int i = 0; i < positions.length; i++) positions[i] = front.positions()[i % (3 * n)];
        for (int i = 0; i < faces.length / 2; i++) {
            faces[i] = front.faceWedges()[i];
            faces[faces.length / 2 + i] = n + front.faceWedges()[i / 3 * 3 + 2 - i % 3];
        }
        Mesh sheet = new MeshBuilder().positions(positions).faceWedges(faces).build();
        assertThat(VertexMerger.merge(sheet, notes)).isSameAs(sheet);
        assertThat(notes).isEmpty();
    }

    @Test
    void shouldTellZerosOfDifferentSignApart() {
        Mesh square = new MeshBuilder()
                .positions(new float[] {0f, 0, 0, 1, 0, 0, 1, 1, 0, -0f, 0, 0, 0, 1, 0})
                .faceWedges(new int[] {0, 1, 2, 3, 2, 4})
                .build();
        assertThat(VertexMerger.merge(square, notes)).isSameAs(square);
    }

    /** Gives every corner a vertex of its own. */
    private static Mesh apart(Mesh mesh) {
        int[] corners = mesh.faceWedges();
        float[] all = new float[3 * corners.length];
        int[] wedgeVertices = new int[corners.length];
        int[] wedges = new int[corners.length];
        int[][] values = new int[mesh.channels().size()][];
        for (int c = 0; c < values.length; c++)
            values[c] = new int[corners.length * mesh.channels().get(c).components()];
        for (int i = 0; i < corners.length; i++) {
            wedges[i] = i;
            wedgeVertices[i] = i;
            System.arraycopy(mesh.positions(), 3 * mesh.wedgeVertices()[corners[i]], all, 3 * i, 3);
            for (int c = 0; c < values.length; c++) {
                int k = mesh.channels().get(c).components();
                System.arraycopy(mesh.channels().get(c).values(), k * corners[i], values[c], k * i, k);
            }
        }
        List<Channel> channels = new ArrayList<>();
        for (int c = 0; c < values.length; c++)
            channels.add(mesh.channels().get(c).withValues(values[c], null));
        return MeshBuilder.from(mesh)
                .positions(all)
                .wedgeVertices(wedgeVertices)
                .faceWedges(wedges)
                .channels(channels)
                .build();
    }

    private static int fans(Mesh mesh) {
        CornerTable table = new ManifoldCut(mesh).table();
        int n = 0;
        for (int v = 0; v < table.vertices(); v++) if (table.cornerOf(v) >= 0) n++;
        return n;
    }
}
