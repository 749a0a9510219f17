package org.jsmesh.upload;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.stream.Stream;
import org.jsmesh.files.ModelInputs;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.sandbox.EncodingFailure;
import org.jsmesh.sandbox.ModelEncoder;
import org.jsmesh.test.Await;
import org.jsmesh.test.LockProbe;
import org.junit.jupiter.api.Test;

/** The spool folder and what is encoded out of it. */
class UploadQueueTest extends UploadQueueFixture {
    @Test
    void shouldPutTheArchiveInItsPlaceAndLeaveNothingElse() throws Exception {
        open(copying());
        send("chair", "model");
        assertThat(await("chair").state()).isEqualTo(UploadStatus.State.READY);
        assertThat(folder.resolve("up/chair.jsm")).hasContent("model");
        assertThat(changes).hasSize(1);
        assertThat(spool()).isEmpty();
        assertThat(queue.length()).isZero();
    }

    @Test
    void shouldGoOnAfterAStopInTheMiddle() throws Exception {
        CountDownLatch begun = new CountDownLatch(1);
        open((model, archive, progress) -> {
            Files.writeString(archive, "half");
            begun.countDown();
            Thread.sleep(60_000);
            return new ModelInputs();
        });
        send("chair", "first");
        send("table", "second");
        Await.open("the encoder to begin", begun);
        queue.close();
        assertThat(folder.resolve("up/chair.jsm")).doesNotExist();
        assertThat(spool()).hasSize(2);
        open((model, archive, progress) -> {
            Files.deleteIfExists(archive);
            return copying().encode(model, archive, progress);
        });
        assertThat(await("table").state()).isEqualTo(UploadStatus.State.READY);
        assertThat(encoded).containsExactly("first", "second");
        assertThat(folder.resolve("up/chair.jsm")).hasContent("first");
        assertThat(spool()).isEmpty();
    }

    @Test
    void shouldShareItsFolderWithNobody() throws Exception {
        open(copying());
        assertThatThrownBy(() -> new UploadQueue(settings, folder.resolve("up"), copying(), () -> {}))
                .isInstanceOf(FileSystemException.class)
                .hasMessageContaining("another server");
        // The refused attempt must not have freed what other processes ask for.
        assertThat(LockProbe.isFree(folder.resolve("up/.lock"))).isFalse();
        queue.close();
        assertThat(LockProbe.isFree(folder.resolve("up/.lock"))).isTrue();
        open(copying());
    }

    @Test
    void shouldForgetWhatDidNotComeWhole() throws Exception {
        open(copying());
        InputStream broken = new InputStream() {
            private int count;

            @Override
            public int read() throws IOException {
                if (count++ > 500) throw new IOException("gone");
                return 'x';
            }
        };
        try (Upload upload = queue.begin(SENDER, "chair", "ply")) {
            assertThatThrownBy(() -> upload.receive(broken)).hasMessage("gone");
        }
        assertThat(spool()).isEmpty();
        Path left = Files.createDirectories(folder.resolve("up/.spool/1234567890123456789-chair"));
        Files.writeString(left.resolve("part"), "half");
        Files.createDirectories(folder.resolve("up/.spool/nonsense"));
        queue.close();
        open(copying());
        assertThat(spool()).isEmpty();
        assertThat(queue.status("chair")).isNull();
    }

    @Test
    void shouldStopReadingWhenThereIsTooMuch() throws Exception {
        open(copying());
        int[] read = {0};
        InputStream endless = new InputStream() {
            @Override
            public int read() {
                read[0]++;
                return 'x';
            }
        };
        try (Upload upload = queue.begin(SENDER, "chair", "ply")) {
            assertThat(upload.receive(endless)).isGreaterThan(1000);
        }
        assertThat(read[0]).isLessThan(200_000);
        assertThat(spool()).isEmpty();
    }

    @Test
    void shouldTakeNoMoreThanTheQueueHolds() throws Exception {
        CountDownLatch go = new CountDownLatch(1);
        open((model, archive, progress) -> {
            Await.open("the test to let the encoder go on", go);
            return copying().encode(model, archive, progress);
        });
        send("a", "1");
        send("b", "2");
        Upload third = queue.begin(SENDER, "c", "ply");
        assertThat(queue.begin(SENDER, "d", "ply")).isNull();
        third.close();
        send("d", "4");
        assertThat(queue.begin(SENDER, "e", "ply")).isNull();
        assertThat(queue.status("b").state()).isEqualTo(UploadStatus.State.QUEUED);
        go.countDown();
        await("d");
        assertThat(encoded).containsExactly("1", "2", "4");
        assertThat(queue.begin(SENDER, "e", "ply")).isNotNull();
    }

    @Test
    void shouldTellWhatIsWrongAndGoOn() throws Exception {
        open((model, archive, progress) -> {
            if (Files.readString(model).equals("bad")) throw EncodingFailure.ofModel("it is bad", "make it good");
            if (Files.readString(model).equals("odd")) throw new IllegalStateException("a fault");
            if (Files.readString(model).equals("huge")) throw new StackOverflowError("a greater fault");
            return copying().encode(model, archive, progress);
        });
        send("a", "bad");
        send("b", "odd");
        await("b");
        send("d", "huge");
        send("c", "good");
        await("c");
        assertThat(queue.status("d").state()).isEqualTo(UploadStatus.State.FAILED);
        assertThat(queue.status("a").error()).isEqualTo("it is bad");
        assertThat(queue.status("a").remedy()).isEqualTo("make it good");
        assertThat(queue.status("b").state()).isEqualTo(UploadStatus.State.FAILED);
        assertThat(folder.resolve("up/a.jsm")).doesNotExist();
        assertThat(folder.resolve("up/c.jsm")).exists();
        assertThat(spool()).isEmpty();
    }

    @Test
    void shouldGiveUpAModelThatBringsTheServerDownAgainAndAgain() throws Exception {
        Path models = folder.resolve("up");
        for (int time = 1; time <= 3; time++) {
            CountDownLatch begun = new CountDownLatch(1);
            queue = new UploadQueue(settings, models, halting(begun), () -> {});
            if (time == 1) send("chair", "poison");
            Await.open("the encoder to begin", begun);
            // What a server that is killed at this moment leaves behind.
            models = copy(models, folder.resolve("up" + time));
            queue.close();
        }
        queue = new UploadQueue(settings, models, copying(), () -> {});
        UploadStatus status = await("chair");
        assertThat(status.state()).isEqualTo(UploadStatus.State.FAILED);
        assertThat(status.error()).contains("3 times");
        assertThat(encoded).isEmpty();
        assertThat(models.resolve(".spool")).isEmptyDirectory();
    }

    @Test
    void shouldNotCountStopsInGoodOrder() throws Exception {
        for (int time = 1; time <= 5; time++) {
            CountDownLatch begun = new CountDownLatch(1);
            open(halting(begun));
            if (time == 1) send("chair", "model");
            Await.open("the encoder to begin", begun);
            queue.close();
        }
        open(copying());
        assertThat(await("chair").state()).isEqualTo(UploadStatus.State.READY);
    }

    private static ModelEncoder halting(CountDownLatch begun) {
        return (model, archive, progress) -> {
            begun.countDown();
            new CountDownLatch(1).await();
            return new ModelInputs();
        };
    }

    private static Path copy(Path from, Path to) throws IOException {
        try (Stream<Path> all = Files.walk(from)) {
            for (Path file : all.toList()) Files.copy(file, to.resolve(from.relativize(file)));
        }
        return to;
    }

    @Test
    void shouldTellOfTheModelThatWasSentLast() throws Exception {
        CountDownLatch begun = new CountDownLatch(1);
        CountDownLatch sentAgain = new CountDownLatch(1);
        CountDownLatch told = new CountDownLatch(1);
        CountDownLatch end = new CountDownLatch(1);
        open((model, archive, progress) -> {
            begun.countDown();
            Await.open("the second upload", sentAgain);
            progress.progress("simplifying", .5);
            told.countDown();
            Await.open("the test to let the encoder end", end);
            Files.copy(model, archive);
            return new ModelInputs();
        });
        send("chair", "first");
        Await.open("the encoder to begin", begun);
        send("chair", "second");
        sentAgain.countDown();
        Await.open("the encoder's progress", told);
        assertThat(queue.status("chair").state()).isEqualTo(UploadStatus.State.QUEUED);
        end.countDown();
        assertThat(await("chair").state()).isEqualTo(UploadStatus.State.READY);
        assertThat(folder.resolve("up/chair.jsm")).hasContent("second");
    }

    @Test
    void shouldStayAtItsEndWhateverIsHeardLater() throws Exception {
        List<ProgressListener> listeners = new CopyOnWriteArrayList<>();
        open((model, archive, progress) -> {
            listeners.add(progress);
            throw EncodingFailure.ofModel("it took too long", "send less");
        });
        send("chair", "model");
        await("chair");
        listeners.get(0).progress("simplifying", .5);
        assertThat(queue.status("chair").state()).isEqualTo(UploadStatus.State.FAILED);
    }

    @Test
    void shouldRemoveWhatWaitsWhatIsEncodedAndWhatIsKept() throws Exception {
        CountDownLatch begun = new CountDownLatch(1);
        open((model, archive, progress) -> {
            if (Files.readString(model).equals("long")) {
                begun.countDown();
                new CountDownLatch(1).await();
            }
            return copying().encode(model, archive, progress);
        });
        send("chair", "kept");
        await("chair");
        send("chair", "long");
        Await.open("the encoder to begin", begun);
        send("chair", "waiting");
        send("table", "other");
        assertThat(queue.remove("chair")).isTrue();
        await("table");
        assertThat(encoded).containsExactly("kept", "other");
        assertThat(folder.resolve("up/chair.jsm")).doesNotExist();
        assertThat(queue.status("chair")).isNull();
        assertThat(queue.remove("chair")).isFalse();
        assertThat(spool()).isEmpty();
        send("chair", "again");
        assertThat(await("chair").state()).isEqualTo(UploadStatus.State.READY);
    }
}
