package org.jsmesh.upload;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.test.LockProbe;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The spool folder and what is encoded out of it, with an encoder that copies. */
@Timeout(60)
class UploadQueueTest {
    @TempDir
    private Path folder;

    private final List<String> encoded = new CopyOnWriteArrayList<>();
    private final List<String> changes = new CopyOnWriteArrayList<>();
    private UploadSettings settings;
    private UploadQueue queue;

    @BeforeEach
    void grant() throws IOException {
        Path tokens =
                Files.writeString(folder.resolve("tokens"), "# who\n\n0123456789abcdef\nfedcba9876543210 chair-\n");
        settings = UploadSettings.of(UploadTokens.read(tokens)).withQueued(3).withMostBytes(1000);
    }

    @AfterEach
    void stop() {
        if (queue != null) queue.close();
    }

    private void open(UploadEncoder encoder) throws IOException {
        queue = new UploadQueue(settings, folder.resolve("up"), encoder, () -> changes.add("changed"));
    }

    private UploadEncoder copying() {
        return (model, archive, progress) -> {
            encoded.add(Files.readString(model));
            Files.copy(model, archive);
        };
    }

    private void send(String id, String text) throws IOException {
        send(id, "ply", text.getBytes(StandardCharsets.UTF_8));
    }

    private void send(String id, String extension, byte[] bytes) throws IOException {
        try (Upload upload = queue.begin(id, extension)) {
            upload.receive(new ByteArrayInputStream(bytes));
            upload.accept();
        }
    }

    private UploadStatus await(String id) throws InterruptedException {
        while (queue.status(id) == null || !queue.status(id).isOver()) Thread.sleep(2);
        while (queue.length() > 0) Thread.sleep(2);
        return queue.status(id);
    }

    private List<Path> spool() throws IOException {
        try (Stream<Path> files = Files.list(folder.resolve("up/.spool"))) {
            return files.toList();
        }
    }

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
        });
        send("chair", "first");
        send("table", "second");
        begun.await();
        queue.close();
        assertThat(folder.resolve("up/chair.jsm")).doesNotExist();
        assertThat(spool()).hasSize(2);
        open((model, archive, progress) -> {
            Files.deleteIfExists(archive);
            copying().encode(model, archive, progress);
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
        try (Upload upload = queue.begin("chair", "ply")) {
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
        try (Upload upload = queue.begin("chair", "ply")) {
            assertThat(upload.receive(endless)).isGreaterThan(1000);
        }
        assertThat(read[0]).isLessThan(200_000);
        assertThat(spool()).isEmpty();
    }

    @Test
    void shouldTakeNoMoreThanTheQueueHolds() throws Exception {
        CountDownLatch go = new CountDownLatch(1);
        open((model, archive, progress) -> {
            go.await();
            copying().encode(model, archive, progress);
        });
        send("a", "1");
        send("b", "2");
        Upload third = queue.begin("c", "ply");
        assertThat(queue.begin("d", "ply")).isNull();
        third.close();
        send("d", "4");
        assertThat(queue.begin("e", "ply")).isNull();
        assertThat(queue.status("b").state()).isEqualTo(UploadStatus.State.QUEUED);
        go.countDown();
        await("d");
        assertThat(encoded).containsExactly("1", "2", "4");
        assertThat(queue.begin("e", "ply")).isNotNull();
    }

    @Test
    void shouldTellWhatIsWrongAndGoOn() throws Exception {
        open((model, archive, progress) -> {
            if (Files.readString(model).equals("bad")) throw new UploadFailure("it is bad", "make it good");
            if (Files.readString(model).equals("odd")) throw new IllegalStateException("a fault");
            if (Files.readString(model).equals("huge")) throw new StackOverflowError("a greater fault");
            copying().encode(model, archive, progress);
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
            begun.await();
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
            begun.await();
            queue.close();
        }
        open(copying());
        assertThat(await("chair").state()).isEqualTo(UploadStatus.State.READY);
    }

    private static UploadEncoder halting(CountDownLatch begun) {
        return (model, archive, progress) -> {
            begun.countDown();
            new CountDownLatch(1).await();
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
            sentAgain.await();
            progress.progress("simplifying", .5);
            told.countDown();
            end.await();
            Files.copy(model, archive);
        });
        send("chair", "first");
        begun.await();
        send("chair", "second");
        sentAgain.countDown();
        told.await();
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
            throw new UploadFailure("it took too long", "send less");
        });
        send("chair", "model");
        await("chair");
        listeners.get(0).progress("simplifying", .5);
        assertThat(queue.status("chair").state()).isEqualTo(UploadStatus.State.FAILED);
    }

    @Test
    void shouldBlameNamesThatNoFolderTakes() throws Exception {
        settings = settings.withMostBytes(10_000);
        open(copying());
        send("a", "zip", zip("x", "file", "x/chair.obj", "obj"));
        assertThat(await("a").error()).contains("file and a folder");
        send("b", "zip", zip("x/chair.obj", "obj", "x", "file"));
        assertThat(await("b").error()).contains("file and a folder");
        send("c", "zip", zip("x".repeat(300) + ".obj", "obj"));
        assertThat(await("c").error()).contains("too long");
        send("d", "zip", zip(("x".repeat(200) + "/").repeat(10) + "chair.obj", "obj"));
        assertThat(await("d").error()).contains("too long");
        assertThat(encoded).isEmpty();
    }

    @Test
    void shouldUnpackAModelWithItsMaterials() throws Exception {
        open((model, archive, progress) -> {
            assertThat(model.resolveSibling("tex/wood.png")).hasContent("wood");
            copying().encode(model, archive, progress);
        });
        send("chair", "zip", zip("chair.obj", "obj", "chair.mtl", "mtl", "tex/wood.png", "wood", "readme.txt", "x"));
        assertThat(await("chair").error()).isNull();
        assertThat(encoded).containsExactly("obj");
    }

    @ParameterizedTest
    @ValueSource(strings = {"../x.obj", "/etc/x.obj", "a/../../x.obj", "..\\x.obj", "a/../.", "x\0.obj"})
    void shouldNotUnpackOutOfTheFolder(String name) throws Exception {
        open(copying());
        send("chair", "zip", zip(name, "evil"));
        assertThat(await("chair").state()).isEqualTo(UploadStatus.State.FAILED);
        assertThat(encoded).isEmpty();
        try (Stream<Path> all = Files.walk(folder)) {
            assertThat(all.filter(f -> f.getFileName().toString().contains("x.obj")))
                    .isEmpty();
        }
    }

    @Test
    void shouldNotUnpackBombs() throws Exception {
        open(copying());
        send("a", "zip", zip("big.obj", "x".repeat(100_000)));
        assertThat(await("a").error()).contains("more bytes than allowed");
        send("b", "zip", "no zip".getBytes(StandardCharsets.UTF_8));
        assertThat(await("b").error()).contains("no ZIP archive");
        send("c", "zip", zip("a.obj", "1", "b.ply", "2"));
        assertThat(await("c").error()).contains("2 model files");
        byte[] whole = zip("a.obj", "1".repeat(300));
        send("d", "zip", java.util.Arrays.copyOf(whole, 40));
        assertThat(await("d").state()).isEqualTo(UploadStatus.State.FAILED);
        assertThat(encoded).isEmpty();
        assertThat(spool()).isEmpty();
    }

    @Test
    void shouldUnpackWhereTheFolderIsNamedByDots() throws Exception {
        Path dotted = folder.resolve(".").resolve("up").resolve("..").resolve("up");
        queue = new UploadQueue(settings, dotted, copying(), () -> {});
        send("chair", "zip", zip("chair.obj", "obj"));
        assertThat(await("chair").error()).isNull();
        assertThat(encoded).containsExactly("obj");
    }

    @Test
    void shouldCountWhatHidesInFoldersOfBombs() throws Exception {
        open(copying());
        send("a", "zip", zip("folder/", "x".repeat(100_000), "chair.obj", "obj"));
        assertThat(await("a").error()).contains("more bytes than allowed");
        assertThat(encoded).isEmpty();
    }

    @Test
    void shouldNotMakeFoldersWithoutEnd() throws Exception {
        open(copying());
        send("a", "zip", zip("a/".repeat(40) + "chair.obj", "obj"));
        assertThat(await("a").error()).contains("too deep");
        assertThat(encoded).isEmpty();
    }

    private static byte[] zip(String... namesAndTexts) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(out)) {
            for (int i = 0; i < namesAndTexts.length; i += 2) {
                zip.putNextEntry(new ZipEntry(namesAndTexts[i]));
                zip.write(namesAndTexts[i + 1].getBytes(StandardCharsets.UTF_8));
            }
        }
        return out.toByteArray();
    }

    @Test
    void shouldKnowWhatATokenIsGoodFor() {
        UploadTokens tokens = settings.tokens();
        assertThat(tokens.check("0123456789abcdef", "table")).isEqualTo(UploadTokens.Verdict.GOOD);
        assertThat(tokens.check("fedcba9876543210", "chair-1")).isEqualTo(UploadTokens.Verdict.GOOD);
        assertThat(tokens.check("fedcba9876543210", "table")).isEqualTo(UploadTokens.Verdict.ELSEWHERE);
        assertThat(tokens.check("0123456789abcdeF", "table")).isEqualTo(UploadTokens.Verdict.UNKNOWN);
        assertThat(tokens.check("", "table")).isEqualTo(UploadTokens.Verdict.UNKNOWN);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "# none\n", "short\n", "0123456789abcdef a b\n"})
    void shouldRefuseFilesWithoutTokens(String text) throws IOException {
        Path file = Files.writeString(folder.resolve("bad"), text);
        assertThatThrownBy(() -> UploadTokens.read(file))
                .isInstanceOf(FileSystemException.class)
                .hasMessageContaining("bad");
    }
}
