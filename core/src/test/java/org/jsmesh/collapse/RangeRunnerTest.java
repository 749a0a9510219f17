package org.jsmesh.collapse;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicIntegerArray;
import org.junit.jupiter.api.Test;

class RangeRunnerTest {
    private static final int SIZE = 100_000;

    @Test
    void shouldDoEveryElementOnce() {
        ExecutorService executor = Executors.newFixedThreadPool(2);
        try {
            AtomicIntegerArray done = new AtomicIntegerArray(SIZE);
            new RangeRunner(executor, 3).run(SIZE, (worker, from, to) -> {
                assertThat(worker).isBetween(0, 2);
                for (int i = from; i < to; i++) done.incrementAndGet(i);
            });
            for (int i = 0; i < SIZE; i++) assertThat(done.get(i)).isEqualTo(1);
        } finally {
            executor.shutdown();
        }
    }

    @Test
    void shouldNotWaitForHelpersThatNeverBegin() {
        List<Runnable> neverRun = new ArrayList<>();
        int[] done = {0};
        new RangeRunner(neverRun::add, 4).run(SIZE, (worker, from, to) -> done[0] += to - from);
        assertThat(done[0]).isEqualTo(SIZE);
        assertThat(neverRun).hasSize(3);
        neverRun.forEach(Runnable::run); // too late to do anything
        assertThat(done[0]).isEqualTo(SIZE);
    }

    @Test
    void shouldPassOnWhatAHelperThrows() {
        RangeRunner runner = new RangeRunner(Runnable::run, 2); // the first helper does it all before the caller begins
        assertThatThrownBy(() -> runner.run(SIZE, (worker, from, to) -> {
                    throw new IllegalStateException("worker " + worker);
                }))
                .hasMessage("worker 1");
    }

    @Test
    void shouldRefuseToWorkWithoutThreads() {
        assertThatThrownBy(() -> new RangeRunner(Runnable::run, 0)).isInstanceOf(IllegalArgumentException.class);
    }
}
