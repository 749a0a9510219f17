package org.jsmesh.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class KeyHashTest {
    private static final int SLOTS = 1 << 16;

    private static KeyHash hash(int seed) {
        Random random = new Random(seed);
        return new KeyHash(random.nextInt(), random.nextInt(), random.nextInt());
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 4, 5, 6, 7})
    void shouldSpreadKeysThatMeetWithOtherFactors(int seed) {
        KeyHash known = hash(4711);
        List<int[]> meeting = new ArrayList<>();
        for (int a = 0; a < 2048; a++) {
            for (int b = 0; b < 2048; b++) if ((known.of(a, b) & SLOTS - 1) == 0) meeting.add(new int[] {a, b});
        }
        assertThat(meeting).hasSizeGreaterThan(20);
        KeyHash hash = hash(seed);
        Set<Integer> slots = new HashSet<>();
        for (int[] key : meeting) slots.add(hash.of(key[0], key[1]) & SLOTS - 1);
        assertThat(slots).hasSizeGreaterThan(meeting.size() * 9 / 10);
    }

    /** Sums and products alone leave the lower bits of such keys alike. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 4, 5, 6, 7})
    void shouldSpreadPlacesThatDifferInTheirHighestBitsAlone(int seed) {
        KeyHash hash = hash(seed);
        Set<Integer> slots = new HashSet<>();
        for (int i = 0; i < 16 * 16 * 16; i++) slots.add(hash.of(i << 28, i >> 4 << 28, i >> 8 << 28) & SLOTS - 1);
        assertThat(slots).hasSizeGreaterThan(16 * 16 * 16 / 8);
    }
}
