package org.jsmesh.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class KeyHashTest {
    private static final int SLOTS = 1 << 16;

    @ParameterizedTest
    @ValueSource(longs = {0, 1, -1, 42, Long.MIN_VALUE})
    void shouldSpreadKeysThatMeetWithAnotherSeed(long seed) {
        KeyHash known = new KeyHash(2, 4711);
        List<int[]> meeting = new ArrayList<>();
        for (int a = 0; a < 2048; a++) {
            for (int b = 0; b < 2048; b++) if ((known.of(a, b) & SLOTS - 1) == 0) meeting.add(new int[] {a, b});
        }
        assertThat(meeting).hasSizeGreaterThan(20);
        KeyHash hash = new KeyHash(2, seed);
        Set<Integer> slots = new HashSet<>();
        for (int[] key : meeting) slots.add(hash.of(key[0], key[1]) & SLOTS - 1);
        assertThat(slots).hasSizeGreaterThan(meeting.size() * 9 / 10);
    }

    /** Multiplying by an odd factor and shifting a little keeps such keys together, whatever the factor is. */
    @ParameterizedTest
    @ValueSource(longs = {0, 1, -1, 42, Long.MIN_VALUE})
    void shouldSpreadKeysThatDifferInTheirHighestBitsAlone(long seed) {
        int words = 12;
        KeyHash hash = new KeyHash(words, seed);
        Set<Integer> slots = new HashSet<>();
        for (int bits = 0; bits < 1 << words; bits++) {
            int[] key = new int[words];
            for (int i = 0; i < words; i++) key[i] = (bits >> i & 1) << 31;
            slots.add(hash.of(key, 0) & SLOTS - 1);
        }
        assertThat(slots).hasSizeGreaterThan((1 << words) * 9 / 10);
    }

    /** Sums and products alone leave the lower bits of such keys alike. */
    @ParameterizedTest
    @ValueSource(longs = {0, 1, -1, 42, Long.MIN_VALUE})
    void shouldSpreadPlacesThatDifferInTheirHighestBitsAlone(long seed) {
        KeyHash hash = new KeyHash(0, seed);
        Set<Integer> slots = new HashSet<>();
        for (int i = 0; i < 16 * 16 * 16; i++) slots.add(hash.of(i << 28, i >> 4 << 28, i >> 8 << 28) & SLOTS - 1);
        assertThat(slots).hasSizeGreaterThan(16 * 16 * 16 / 8);
    }
}
