package org.jsmesh.archive;

import static org.assertj.core.api.Assertions.assertThat;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.lifecycle.AddLifecycleHook;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.test.FewerTries;
import org.jsmesh.test.RandomMeshes;

/** Archives of meshes that the paper's method simplified. */
@AddLifecycleHook(FewerTries.class)
class PaperRoundTripTest {
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
}
