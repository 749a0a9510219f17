package org.jsmesh.upload;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.jsmesh.files.ModelInputs;
import org.jsmesh.sandbox.ModelEncoder;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A queue with a spool folder and an encoder that copies. */
@Timeout(60)
abstract class UploadQueueFixture {
    static final Sender SENDER = new Sender("a".repeat(64), Long.MAX_VALUE, Integer.MAX_VALUE);

    @TempDir
    Path folder;

    final List<String> encoded = new CopyOnWriteArrayList<>();
    final List<String> changes = new CopyOnWriteArrayList<>();
    UploadSettings settings;
    UploadQueue queue;

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

    void open(ModelEncoder encoder) throws IOException {
        queue = new UploadQueue(settings, folder.resolve("up"), encoder, () -> changes.add("changed"));
    }

    ModelEncoder copying() {
        return (model, archive, progress) -> {
            encoded.add(Files.readString(model));
            Files.copy(model, archive);
            return new ModelInputs();
        };
    }

    void send(String id, String text) throws Exception {
        send(id, "ply", text.getBytes(StandardCharsets.UTF_8));
    }

    void send(String id, String extension, byte[] bytes) throws Exception {
        try (Upload upload = queue.begin(SENDER, id, extension)) {
            upload.receive(new ByteArrayInputStream(bytes));
            upload.accept();
        }
    }

    UploadStatus await(String id) throws Exception {
        Await.until(
                "the end of " + id,
                () -> queue.status(id) != null && queue.status(id).isOver());
        Await.until("an empty queue", () -> queue.length() == 0);
        return queue.status(id);
    }

    List<Path> spool() throws IOException {
        try (Stream<Path> files = Files.list(folder.resolve("up/.spool"))) {
            return files.toList();
        }
    }

    static byte[] zip(String... namesAndTexts) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(out)) {
            for (int i = 0; i < namesAndTexts.length; i += 2) {
                zip.putNextEntry(new ZipEntry(namesAndTexts[i]));
                zip.write(namesAndTexts[i + 1].getBytes(StandardCharsets.UTF_8));
            }
        }
        return out.toByteArray();
    }
}
