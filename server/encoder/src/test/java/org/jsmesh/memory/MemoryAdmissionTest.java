package org.jsmesh.memory;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicLong;
import org.jsmesh.memory.MemoryAdmission.Admission;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class MemoryAdmissionTest {
    private final MemoryAdmission gate = new MemoryAdmission(100);

    @Test
    void shouldAdmitWhatFits() throws InterruptedException {
        try (Admission a = gate.admit(60);
                Admission b = gate.admit(40)) {
            assertThat(gate.taken()).isEqualTo(100);
            assertThat(gate.inside()).isEqualTo(2);
            assertThat(gate.admit(1, 0)).isNull();
            assertThat(a.isAlone() || b.isAlone()).isFalse();
        }
        assertThat(gate.taken()).isZero();
    }

    @Test
    void shouldLetWhatIsLargerThanTheWholeRunAlone() throws InterruptedException {
        try (Admission large = gate.admit(1000)) {
            assertThat(large.isAlone()).isTrue();
            assertThat(gate.admit(1, 0)).isNull();
            assertThat(gate.admit(0, 0)).as("nothing fits always").isNotNull();
        }
        assertThat(gate.admit(100, 0)).isNotNull();
    }

    @Test
    void shouldGiveBackOnlyOnce() throws InterruptedException {
        Admission a = gate.admit(50);
        gate.admit(50);
        a.close();
        a.close();
        assertThat(gate.taken()).isEqualTo(50);
    }

    @Test
    void shouldNotLetSmallWorkOvertakeLargeWorkForEver() throws Exception {
        Admission first = gate.admit(50);
        List<String> order = Collections.synchronizedList(new ArrayList<>());
        Thread large = waiting(80, order, "large");
        Thread small = waiting(30, order, "small");
        assertThat(gate.admit(1, 0)).as("somebody waits already").isNull();
        first.close();
        large.join();
        small.join();
        assertThat(order).containsExactly("large", "small");
        assertThat(gate.inside()).isZero();
    }

    private Thread waiting(long bytes, List<String> order, String name) throws InterruptedException {
        Thread thread = new Thread(() -> {
            try (Admission a = gate.admit(bytes)) {
                order.add(a.bytes() == bytes ? name : "wrong");
            } catch (InterruptedException e) {
                order.add("interrupted");
            }
        });
        thread.start();
        for (Thread.State state = thread.getState(); ; state = thread.getState()) {
            if (state == Thread.State.WAITING || state == Thread.State.TIMED_WAITING) return thread;
            assertThat(state).as(name + " did not wait").isNotEqualTo(Thread.State.TERMINATED);
            Thread.sleep(1);
        }
    }

    @Test
    void shouldLetOthersInWhenOneStopsWaiting() throws Exception {
        Admission first = gate.admit(50);
        List<String> order = Collections.synchronizedList(new ArrayList<>());
        Thread large = waiting(80, order, "large");
        Thread small = waiting(30, order, "small");
        large.interrupt();
        small.join(); // the first has not left
        large.join();
        assertThat(order).containsExactlyInAnyOrder("interrupted", "small");
        first.close();
        assertThat(gate.taken()).isZero();
    }

    @Test
    void shouldGiveUpInTime() throws InterruptedException {
        gate.admit(100);
        assertThat(gate.admit(1, 20)).isNull();
    }

    @Test
    void shouldNeverHoldMoreThanTheWhole() throws Exception {
        ExecutorService pool = Executors.newFixedThreadPool(8);
        AtomicLong inside = new AtomicLong();
        AtomicLong most = new AtomicLong();
        CountDownLatch begin = new CountDownLatch(1);
        List<Future<?>> all = new ArrayList<>();
        for (int i = 0; i < 400; i++) {
            long bytes = 1 + i * 37 % 110;
            all.add(pool.submit(() -> {
                begin.await();
                try (Admission a = gate.admit(bytes)) {
                    long now = inside.addAndGet(a.bytes());
                    most.accumulateAndGet(now, Math::max);
                    Thread.onSpinWait();
                    inside.addAndGet(-a.bytes());
                }
                return null;
            }));
        }
        begin.countDown();
        for (Future<?> f : all) f.get();
        pool.shutdown();
        assertThat(most.get()).isBetween(1L, 100L);
        assertThat(gate.taken()).isZero();
    }

    @Test
    void shouldRefuseWhatMakesNoSense() {
        assertThatThrownBy(() -> new MemoryAdmission(0)).hasMessageContaining("0");
        assertThatThrownBy(() -> gate.admit(-1)).hasMessageContaining("-1");
        assertThat(MemoryAdmission.ofHeap().capacity())
                .isLessThan(Runtime.getRuntime().maxMemory());
    }
}
