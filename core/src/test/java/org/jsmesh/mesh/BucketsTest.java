package org.jsmesh.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

class BucketsTest {
    @Test
    void shouldKeepTheOrderOfTheItemsOfAKey() {
        int[] keys = {3, 0, 3, 4, 0, 3};
        Buckets buckets = new Buckets(5);
        for (int key : keys) buckets.count(key);
        buckets.lay();
        for (int i = 0; i < keys.length; i++) buckets.add(keys[i], i);
        assertThat(of(buckets, 0)).containsExactly(1, 4);
        assertThat(of(buckets, 1)).isEmpty();
        assertThat(of(buckets, 2)).isEmpty();
        assertThat(of(buckets, 3)).containsExactly(0, 2, 5);
        assertThat(of(buckets, 4)).containsExactly(3);
    }

    private static int[] of(Buckets buckets, int key) {
        return Arrays.copyOfRange(buckets.items(), buckets.start(key), buckets.end(key));
    }
}
