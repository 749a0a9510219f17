package org.jsmesh.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;

class FaceChannelTest {
    private static FaceChannel groups(Mesh mesh, String... labels) {
        int[] values = new int[mesh.faces()];
        for (int f = 0; f < values.length; f++) values[f] = f % labels.length;
        return new FaceChannel(FaceChannel.GROUP, 1, Channel.Type.INT32, values, List.of(labels));
    }

    private static Mesh with(Mesh mesh, FaceChannel... channels) {
        return MeshBuilder.from(mesh).faceChannels(List.of(channels)).build();
    }

    @Test
    void shouldBePartOfTheIdentity() {
        Mesh mesh = RandomMeshes.FLAT_GRID.mesh(1);
        Mesh named = with(mesh, groups(mesh, "wheel", "body"));
        assertThat(MeshIdentity.sha256(named)).isNotEqualTo(MeshIdentity.sha256(mesh));
        assertThat(MeshIdentity.sha256(with(mesh, groups(mesh, "body", "wheel"))))
                .isNotEqualTo(MeshIdentity.sha256(named));
        FaceChannel renumbered = groups(mesh, "unused", "body", "wheel");
        for (int f = 0; f < renumbered.values().length; f++) renumbered.values()[f] = 2 - f % 2;
        assertThat(MeshIdentity.sha256(with(mesh, renumbered))).isEqualTo(MeshIdentity.sha256(named));
    }

    @Test
    void shouldBeComparedByTheirNames() {
        Mesh mesh = RandomMeshes.FLAT_GRID.mesh(1);
        Mesh named = with(mesh, groups(mesh, "wheel"));
        assertThat(MeshComparison.firstDifference(named, with(mesh, groups(mesh, "wheel"))))
                .isEmpty();
        assertThat(MeshComparison.firstDifference(named, with(mesh, groups(mesh, "body")))
                        .orElseThrow())
                .contains("group is 'body', in the original 'wheel'");
        assertThat(MeshComparison.firstDifference(named, mesh).orElseThrow()).contains("it has no group");
        assertThat(MeshComparison.firstDifference(mesh, named).orElseThrow()).contains("it has a group");
    }

    @Test
    void shouldRefuseValuesWithoutALabel() {
        assertThatThrownBy(() -> new FaceChannel("group", 1, Channel.Type.INT32, new int[] {1}, List.of("a")))
                .hasMessage("label 1 of 1 of group");
        assertThatThrownBy(() -> with(
                        RandomMeshes.FLAT_GRID.mesh(1),
                        new FaceChannel("label", 1, Channel.Type.INT8, new int[1], List.of())))
                .hasMessageContaining("channel label has 1 faces of");
    }

    @Test
    void shouldGiveNumbersAsTheyAre() {
        long bits = Double.doubleToRawLongBits(.1);
        FaceChannel channel = new FaceChannel(
                "quality", 1, Channel.Type.FLOAT64, new int[] {(int) bits, (int) (bits >>> 32)}, List.of());
        assertThat(channel.faces()).isEqualTo(1);
        assertThat(channel.exact(0, 0)).isEqualTo(.1);
        assertThat(new FaceChannel("id", 1, Channel.Type.UINT32, new int[] {-1}, List.of()).exact(0, 0))
                .isEqualTo(4294967295.0);
    }
}
