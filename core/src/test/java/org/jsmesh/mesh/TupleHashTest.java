package org.jsmesh.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TupleHashTest {
    private static final int SLOTS = 1 << 16;

    /** Multiplying by an odd factor and shifting a little keeps such tuples together, whatever the factor is. */
    @ParameterizedTest
    @ValueSource(longs = {0, 1, -1, 42, Long.MIN_VALUE})
    void shouldSpreadTuplesThatDifferInTheirHighestBitsAlone(long seed) {
        int words = 12;
        TupleHash hash = new TupleHash(words, seed);
        Set<Integer> slots = new HashSet<>();
        for (int bits = 0; bits < 1 << words; bits++) {
            int[] key = new int[words];
            for (int i = 0; i < words; i++) key[i] = (bits >> i & 1) << 31;
            slots.add(hash.of(key, 0) & SLOTS - 1);
        }
        assertThat(slots).hasSizeGreaterThan((1 << words) * 9 / 10);
    }
}
