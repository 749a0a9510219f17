package org.jsmesh.archive;

import static org.assertj.core.api.Assertions.assertThat;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.lifecycle.AddLifecycleHook;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.test.FewerTries;
import org.jsmesh.test.RandomMeshes;

/** What an archive shows after each of its batches. */
@AddLifecycleHook(FewerTries.class)
class EveryBatchTest {
    @Property(tries = 60, seed = "20022")
    void shouldShowAMeshAfterEveryBatchThatMatchesItsIndex(
            @ForAll RandomMeshes kind, @ForAll @IntRange(max = 1_000_000) int seed) throws Exception {
        byte[] bytes = TestArchives.encodeFar(kind.mesh(seed)).bytes();
        ArchiveDecoder decoder = new ArchiveDecoder();
        int seen = 0;
        for (int i = 0; i < bytes.length; i++) { // byte by byte
            decoder.feed(bytes, i, 1);
            if (decoder.batches() == seen) continue;
            BatchIndex index = decoder.index();
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
        assertThat(decoder.index().archiveBytes()).isEqualTo(bytes.length);
    }
}
