package org.jsmesh.codec.position;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SmallSortTest {
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 9, 15, 16, 17, 40, 198})
    void shouldSortTheFirstNumbers(int count) {
        Random random = new Random(count);
        for (int trial = 0; trial < 200; trial++) {
            int[] numbers = random.ints(198, -9, 9).toArray();
            int[] sorted = Arrays.copyOf(numbers, count);
            Arrays.sort(sorted);
            SmallSort.sort(numbers, count);
            assertThat(Arrays.copyOf(numbers, count)).isEqualTo(sorted);
        }
    }

    /** A network that sorts all zeros and ones sorts everything (Knuth 1973). */
    @Test
    void shouldSortAllZerosAndOnes() {
        for (int bits = 0; bits < 1 << 16; bits++) {
            int[] numbers = new int[16];
            for (int i = 0; i < 16; i++) numbers[i] = bits >> i & 1;
            SmallSort.sort(numbers, 16);
            int zeros = 16 - Integer.bitCount(bits);
            for (int i = 0; i < 16; i++) assertThat(numbers[i]).isEqualTo(i < zeros ? 0 : 1);
        }
    }
}
