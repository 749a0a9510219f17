package org.jsmesh.desktop.draw;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.display.DisplaySlots;
import org.jsmesh.display.LiveStep;
import org.junit.jupiter.api.Test;

class RangeSlicesTest {
    private static RangeSlices of(int... ranges) {
        int[] none = {};
        return new RangeSlices(new LiveStep(1, false, 0, 0, 0, ranges, none, none, DisplaySlots.of(List.of(), false)));
    }

    private static List<List<Integer>> all(RangeSlices slices, int most) {
        List<List<Integer>> found = new ArrayList<>();
        while (slices.next(most)) found.add(List.of(slices.array(), slices.first(), slices.at(), slices.count()));
        return found;
    }

    @Test
    void shouldCutRangesWhereTheyAreTooLarge() {
        assertThat(all(of(0, 30, 5, 3, 6, 3), 2))
                .containsExactly(
                        List.of(0, 30, 0, 2),
                        List.of(0, 32, 2, 2),
                        List.of(0, 34, 4, 1),
                        List.of(3, 6, 5, 2),
                        List.of(3, 8, 7, 1));
    }

    @Test
    void shouldTakeWholeRangesWhereThereIsRoom() {
        RangeSlices slices = of(0, 30, 5, 3, 6, 3);
        assertThat(slices.isOver()).isFalse();
        assertThat(all(slices, 100)).containsExactly(List.of(0, 30, 0, 5), List.of(3, 6, 5, 3));
        assertThat(slices.isOver()).isTrue();
    }

    @Test
    void shouldBeOverAtOnceWithoutRanges() {
        assertThat(of().isOver()).isTrue();
        assertThat(of().next(1)).isFalse();
    }
}
