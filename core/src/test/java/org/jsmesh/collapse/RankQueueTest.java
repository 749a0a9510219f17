package org.jsmesh.collapse;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.FloatRange;
import net.jqwik.api.constraints.Size;

class RankQueueTest {
    @Property(seed = "1")
    void shouldSortByExponentAndTwoDigits(
            @ForAll @Size(max = 300) List<@FloatRange(min = 0, max = 1e30f) Float> values) {
        RankQueue queue = filled(values);
        queue.sort();
        List<Integer> expected = new ArrayList<>();
        for (int i = 0; i < values.size(); i++) expected.add(i);
        expected.sort(Comparator.comparing(i -> Float.floatToRawIntBits(values.get(i)) >> 21));
        for (int i = 0; i < values.size(); i++) assertThat(queue.id(i)).isEqualTo(expected.get(i));
    }

    @Property(seed = "1")
    void shouldFindTheValueAtARank(
            @ForAll @Size(min = 1, max = 300) List<@FloatRange(min = 0, max = 4) Float> values,
            @ForAll @FloatRange(min = 0, max = 400) float rank) {
        List<Float> sorted = new ArrayList<>(values);
        sorted.sort(null);
        assertThat(filled(values).at(rank)).isEqualTo(sorted.get(Math.min(values.size() - 1, (int) rank)));
    }

    private static RankQueue filled(List<Float> values) {
        RankQueue queue = new RankQueue();
        queue.clear(values.size());
        for (int i = 0; i < values.size(); i++) queue.add(values.get(i), i);
        return queue;
    }
}
