package org.jsmesh.display;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.jsmesh.archive.TestArchives;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class LiveStepTest {
    private static Mesh withZeros(Mesh bare) {
        int[] values = new int[2 * bare.wedges()];
        for (int i = 0; i < values.length; i += 7) values[i] = Float.floatToIntBits(i);
        return MeshBuilder.from(bare)
                .channels(List.of(
                        new Channel(Channel.Semantic.TEXCOORD, "TEXCOORD_0", 2, Channel.Type.FLOAT32, values, null)))
                .build();
    }

    @ParameterizedTest
    @EnumSource
    void shouldFillBuffersThatBeginWithAnything(RandomMeshes kind) throws Exception {
        byte[] bytes = TestArchives.encodeFar(withZeros(kind.mesh(1))).bytes();
        ArchiveDecoder decoder = new ArchiveDecoder();
        LiveMesh live = null;
        LiveMeshMirror mirror = new LiveMeshMirror();
        int vertices = 0;
        int shown = 0;
        for (int at = 0; at < bytes.length; at++) {
            decoder.feed(bytes, at, 1);
            if (decoder.batches() == shown) continue;
            shown = decoder.batches();
            if (live == null)
                live = new LiveMesh(decoder.growing(), decoder.opening().materials());
            live.update(.5);
            LiveStep step = LiveStep.of(live, vertices, false);
            vertices = step.vertices();
            mirror.take(step);
            assertThat(step.faces()).isEqualTo(decoder.faces());
            assertThat(mirror.triangles()).isDeepEqualTo(LiveMeshMirror.triangles(RenderMesh.of(decoder.mesh(), .5)));
        }
        assertThat(decoder.isComplete()).isTrue();
        assertThat(shown).isGreaterThan(1);
    }
}
