package org.jsmesh.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Comparator;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RowSorterTest {
    /**
     * Few rows are inserted, some sorted, many sorted by radix; small ranges make many rows alike in the first columns.
     */
    @ParameterizedTest
    @CsvSource({
        "0, 3, 5",
        "1, 1, 5",
        "20, 3, 2",
        "500, 3, 3",
        "5000, 4, 2",
        "5000, 2, 100",
        "9000, 1, 2000000000",
        "3000, 5, 1"
    })
    void shouldSortUnsignedRowsAndKeepTheOrderOfEqualOnes(int count, int width, int range) {
        Random random = new Random(count);
        int[] rows = new int[count * width];
        for (int i = 0; i < rows.length; i++) rows[i] = random.nextInt(range) - range / 2;
        Integer[] expected = new Integer[count];
        Arrays.setAll(expected, i -> i);
        Comparator<Integer> order = (a, b) -> {
            for (int k = 0; k < width; k++) {
                int c = Integer.compareUnsigned(rows[a * width + k], rows[b * width + k]);
                if (c != 0) return c;
            }
            return 0;
        };
        Arrays.sort(expected, order);
        assertThat(RowSorter.order(rows, width, count))
                .containsExactly(Arrays.stream(expected).mapToInt(i -> i).toArray());
    }
}
