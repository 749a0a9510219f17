package org.jsmesh.decode;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashMap;
import java.util.Map;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.TestArchives;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class FaceLevelsTest {
    private static final int PORTION = 333;

    @ParameterizedTest
    @EnumSource
    void shouldCountTheFacesOfEachLevel(RandomMeshes kind) throws Exception {
        byte[] bytes = TestArchives.encodeFar(kind.mesh(2)).bytes();
        BatchIndex index = TestArchives.decode(bytes, bytes.length).header().batches();
        ArchiveDecoder decoder = new ArchiveDecoder();
        FaceLevels levels = new FaceLevels(decoder);
        for (int at = 0; at < bytes.length; at += PORTION) {
            levels.feed(bytes, at, Math.min(PORTION, bytes.length - at));
            if (decoder.batches() == 0 || decoder.isComplete()) continue;
            Mesh mesh = decoder.mesh();
            byte[] of = levels.ofMesh();
            assertThat(of).hasSize(mesh.faces());
            Map<Integer, Integer> counts = new HashMap<>();
            for (byte level : of) counts.merge((int) level, 1, Integer::sum);
            int now = index.level(decoder.batches() - 1);
            int sum = 0;
            for (int level = 0; level <= now; level++) {
                sum += counts.getOrDefault(level, 0);
                int last = 0;
                for (int b = 0; b < decoder.batches(); b++) if (index.level(b) <= level) last = b;
                assertThat(sum).isEqualTo(index.faces(last));
            }
        }
        assertThat(decoder.isComplete()).isTrue();
    }
}
