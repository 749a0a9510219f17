package org.jsmesh.codec.connectivity;

import static org.assertj.core.api.Assertions.assertThat;

import org.jsmesh.codec.entropy.RangeDecoder;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.mesh.CornerTable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class StitchCoderTest {
    /** Both neighbours along the border are fans of one vertex. Its borders lead back to the new fan vertex. */
    @ParameterizedTest
    @ValueSource(ints = {4, 64, 65, 128})
    void shouldNotTakeTheNewFanVertexForACandidate(int u) {
        LodMesh mesh = new LodMesh(false, false, true, u + 1, u + 1, 2);
        for (int fan = 0; fan < u; fan++) mesh.addFan(fan == u - 1 ? u - 2 : mesh.addVertex());
        int p = u - 2;
        int q = u - 1;
        int[] corners = {p, u, 0, u, q, 0};
        int[] opposites = {-1, 5, -1, -1, -1, 1};
        mesh.setTable(CornerTable.of(corners, opposites, 2, u + 1));

        int vertex = new StitchCoder(mesh, null).code(new RangeDecoder(new byte[64], 0, 64), u);

        assertThat(vertex).isBetween(0, mesh.vertices() - 1);
    }
}
