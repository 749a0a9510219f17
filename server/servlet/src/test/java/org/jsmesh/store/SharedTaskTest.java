package org.jsmesh.store;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class SharedTaskTest {
    private final AtomicInteger runs = new AtomicInteger();
    private final AtomicInteger source = new AtomicInteger();
    private final AtomicInteger failures = new AtomicInteger();
    private volatile int seen;

    @Test
    void shouldRunOnceForAllWhoComeMeanwhile() throws Exception {
        CountDownLatch running = new CountDownLatch(1);
        CountDownLatch goOn = new CountDownLatch(1);
        SharedTask task = new SharedTask(() -> {
            seen = source.get();
            if (runs.incrementAndGet() > 1) return;
            running.countDown();
            awaitQuietly(goOn);
        });
        List<Thread> threads = new ArrayList<>();
        threads.add(begin(task, 0));
        Await.open("the first run", running);
        source.set(1); // what the first run does not see, but all who come now must
        for (int i = 0; i < 20; i++) threads.add(begin(task, 1));
        for (Thread thread : threads.subList(1, 21))
            Await.until("a thread to wait for its turn", () -> thread.getState() == Thread.State.BLOCKED);
        goOn.countDown();
        for (Thread thread : threads) Await.until("a thread to end", () -> !thread.isAlive());
        assertThat(runs).hasValue(2);
        assertThat(failures).hasValue(0);
    }

    private static void awaitQuietly(CountDownLatch latch) {
        try {
            Await.open("the test to go on", latch);
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    private Thread begin(SharedTask task, int least) {
        Thread thread = new Thread(() -> {
            try {
                task.run();
                if (seen < least) failures.incrementAndGet();
            } catch (Exception e) {
                failures.incrementAndGet();
            }
        });
        thread.start();
        return thread;
    }

    @Test
    void shouldRunForEveryoneWhoComesAlone() throws Exception {
        SharedTask task = new SharedTask(runs::incrementAndGet);
        for (int i = 1; i < 4; i++) {
            task.run();
            assertThat(runs).hasValue(i);
        }
    }

    @Test
    void shouldRunAgainAfterAFailure() throws Exception {
        SharedTask task = new SharedTask(() -> {
            if (runs.incrementAndGet() == 1) throw new IOException("gone");
        });
        assertThatThrownBy(task::run).hasMessage("gone");
        task.run();
        assertThat(runs).hasValue(2);
    }
}
