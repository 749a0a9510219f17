package org.jsmesh.store.bucket;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.InterruptedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.jsmesh.store.ModelUnavailableException;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class ReadsTest {
    private static final int THREADS = 32;
    private static final int QUEUE = 1024;

    private static String forEver() throws InterruptedIOException {
        try {
            new CountDownLatch(1).await();
        } catch (InterruptedException e) {
            throw new InterruptedIOException();
        }
        return "";
    }

    @Test
    void shouldServeOthersWhenAllThreadsHungAndTheirTimeIsOver() throws Exception {
        try (Reads reads = new Reads("s3://bucket", 500)) {
            List<CompletableFuture<String>> hung = new ArrayList<>();
            for (int i = 0; i < THREADS; i++) hung.add(reads.begin(ReadsTest::forEver));
            for (CompletableFuture<String> one : hung)
                assertThatThrownBy(one::join)
                        .hasCauseInstanceOf(ModelUnavailableException.class)
                        .hasMessageContaining("did not answer within 500 ms");
            // A busy machine may need more than one try.
            Await.until(
                    "a read",
                    () -> reads.begin(() -> "read")
                            .handle((read, failure) -> "read".equals(read))
                            .join());
            assertThat(reads.waiting()).isZero();
        }
    }

    @Test
    void shouldRefuseWhenTooManyWait() throws Exception {
        CountDownLatch gate = new CountDownLatch(1);
        try (Reads reads = new Reads("s3://bucket", 60_000)) {
            List<CompletableFuture<Boolean>> waiting = new ArrayList<>();
            for (int i = 0; i < THREADS + QUEUE; i++) {
                waiting.add(reads.begin(() -> {
                    try {
                        return gate.await(60, TimeUnit.SECONDS);
                    } catch (InterruptedException e) {
                        throw new InterruptedIOException();
                    }
                }));
            }
            assertThat(reads.waiting()).isEqualTo(QUEUE);
            assertThat(waiting).noneMatch(CompletableFuture::isDone);
            assertThatThrownBy(() -> reads.begin(() -> true).join())
                    .isInstanceOf(CompletionException.class)
                    .hasMessageContaining("too many requests wait");
            assertThat(reads.failed()).isEqualTo(1);
            gate.countDown();
            for (CompletableFuture<Boolean> one : waiting)
                assertThat(one.join()).isTrue();
            assertThat(reads.done()).isEqualTo(THREADS + QUEUE);
        }
    }

    @Test
    void shouldInterruptWhatIsReadWhenItIsClosed() throws Exception {
        Reads reads = new Reads("s3://bucket", 60_000);
        CountDownLatch begun = new CountDownLatch(1);
        CompletableFuture<String> read = reads.begin(() -> {
            begun.countDown();
            return forEver();
        });
        Await.open("the read", begun);
        reads.close();
        assertThatThrownBy(read::join).hasCauseInstanceOf(ModelUnavailableException.class);
    }
}
