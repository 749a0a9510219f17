package org.jsmesh.spark;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;

class SamePlaceTest {
    private static SamePlace of(String key) {
        return SamePlace.of(new ListedModel("s3://b", key, "x.ply", 5, "t", Instant.EPOCH));
    }

    @Test
    void shouldCountFilesWhateverTheyAreCalled() {
        assertThat(of("salt and pepper.ply").isTaken()).isFalse();
        SamePlace both = of("b and c.ply").and(of("a.ply"));
        assertThat(both.isTaken()).isTrue();
        assertThat(both.said("x.ply")).isEqualTo("s3://b/a.ply and s3://b/b and c.ply are both x.ply");
    }

    @Test
    void shouldSayTheSameInAnyOrder() {
        List<SamePlace> files = new ArrayList<>(List.of(of("d"), of("b"), of("a"), of("c")));
        for (int i = 0; i < files.size(); i++) {
            SamePlace left = files.get(0).and(files.get(1));
            SamePlace right = files.get(2).and(files.get(3));
            assertThat(left.and(right).said("x")).isEqualTo("s3://b/a, s3://b/b and 2 more are all x");
            assertThat(left.and(files.get(2)).and(files.get(3))).isEqualTo(left.and(right));
            Collections.rotate(files, 1);
        }
    }
}
