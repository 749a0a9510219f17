package org.jsmesh.app.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import javax.imageio.ImageIO;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.files.EncodeJob;
import org.jsmesh.files.EncodeResult;
import org.jsmesh.files.FolderEncodeListener;
import org.jsmesh.files.FolderEncoder;
import org.jsmesh.files.FolderResources;
import org.jsmesh.files.ModelEncoding;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.io.ModelFormat;
import org.jsmesh.sandbox.ModelFilesEncoder;
import org.jsmesh.store.Archive;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;
import org.jsmesh.upload.Upload;
import org.jsmesh.upload.UploadQueue;
import org.jsmesh.upload.UploadSettings;
import org.jsmesh.upload.UploadStatus;
import org.jsmesh.upload.UploadTokens;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A model becomes the same archive by command, served folder, upload, benchmark and library. */
@Tag("long")
@Timeout(300)
@Tag("slow")
class SameArchiveTest {
    private static final Path MODELS = Path.of("../../models");
    private static final EncoderSettings SETTINGS = EncoderSettings.defaults();

    @TempDir
    private Path folder;

    @Test
    void shouldBeTheSameOfAnObjWithMaterialsAndImage() throws Exception {
        Path models = Files.createDirectory(folder.resolve("models"));
        for (String name : List.of("amphora.obj", "amphora.mtl", "amphora.png"))
            Files.copy(MODELS.resolve(name), models.resolve(name));
        assertSameByAllRoads(models.resolve("amphora.obj"), zipped(models), "zip");
    }

    @Test
    void shouldBeTheSameOfAGlbWithItsImageInside() throws Exception {
        Path model = glb(Files.createDirectory(folder.resolve("models")));
        assertSameByAllRoads(model, model, "glb");
    }

    private void assertSameByAllRoads(Path model, Path sent, String extension) throws Exception {
        byte[] expected = byCommand(model);
        assertThat(expected).as("previews count").isNotEqualTo(withoutPictures(model));
        assertThat(served(model)).as("served folder").isEqualTo(expected);
        assertThat(uploaded(sent, extension)).as("upload").isEqualTo(expected);
        assertThat(new WholeEncode(model, SETTINGS)
                        .encode(ProgressListener.NONE)
                        .bytes())
                .as("benchmark")
                .isEqualTo(expected);
        assertThat(new ModelEncoding(SETTINGS)
                        .encode(
                                model.getFileName().toString(),
                                Files.readAllBytes(model),
                                new FolderResources(model.getParent()),
                                ProgressListener.NONE)
                        .bytes())
                .as("library")
                .isEqualTo(expected);
    }

    private static byte[] withoutPictures(Path model) throws IOException {
        return new MeshEncoder(SETTINGS)
                .encode(ModelFiles.read(model).mesh(), ProgressListener.NONE)
                .bytes();
    }

    private byte[] byCommand(Path model) throws Exception {
        Path archive = folder.resolve("command.jsm");
        List<EncodeResult> results = new FolderEncoder(SETTINGS.withThreads(2))
                .encode(List.of(new EncodeJob(model, archive)), FolderEncodeListener.NONE);
        assertThat(results.get(0).error()).isNull();
        return Files.readAllBytes(archive);
    }

    private byte[] served(Path model) throws Exception {
        try (ModelStore store = new ModelStore(
                StoreSettings.of(model.getParent()).withCache(folder.resolve("cache")),
                new ModelFilesEncoder(SETTINGS))) {
            Archive archive = store.archive(store.of(model)).get(2, TimeUnit.MINUTES);
            return archive.copy(0, (int) archive.bytes());
        }
    }

    /** By a process of its own. */
    private byte[] uploaded(Path sent, String extension) throws Exception {
        Path tokens = Files.writeString(folder.resolve("tokens"), "0123456789abcdef0123456789abcdef\n");
        UploadSettings settings = UploadSettings.of(UploadTokens.read(tokens)).withHeapMegabytes(512);
        try (UploadQueue queue = UploadQueue.open(settings, folder.resolve("uploads"), () -> {})) {
            try (Upload upload = queue.begin(
                            settings.tokens().sender("0123456789abcdef0123456789abcdef", "sent"), "sent", extension);
                    InputStream body = Files.newInputStream(sent)) {
                upload.receive(body);
                upload.accept();
            }
            UploadStatus status = queue.status("sent");
            long giveUp = System.nanoTime() + TimeUnit.MINUTES.toNanos(2);
            while (!status.isOver() && System.nanoTime() < giveUp) {
                Thread.sleep(20);
                status = queue.status("sent");
            }
            assertThat(status)
                    .isEqualTo(new UploadStatus("sent", UploadStatus.State.READY, "done", 1, null, null, List.of()));
            return Files.readAllBytes(queue.place("sent"));
        }
    }

    private Path zipped(Path models) throws IOException {
        Path file = folder.resolve("sent.zip");
        try (OutputStream out = Files.newOutputStream(file);
                ZipOutputStream zip = new ZipOutputStream(out);
                Stream<Path> all = Files.list(models)) {
            for (Path one : all.sorted().toList()) {
                zip.putNextEntry(new ZipEntry(one.getFileName().toString()));
                Files.copy(one, zip);
            }
        }
        return file;
    }

    /** A bumpy grid with a chequered image. */
    private Path glb(Path models) throws IOException {
        int side = 30;
        StringBuilder obj = new StringBuilder("mtllib grid.mtl\nusemtl cloth\n");
        for (int i = 0; i < side * side; i++) {
            int x = i % side;
            int y = i / side;
            obj.append(String.format(Locale.ROOT, "v %d %d %.3f%n", x, y, Math.sin(.4 * x) * Math.cos(.3 * y)));
            obj.append(String.format(Locale.ROOT, "vt %.4f %.4f%n", x / (side - 1.), y / (side - 1.)));
        }
        for (int y = 1; y < side; y++) {
            for (int x = 1; x < side; x++) {
                int c = y * side + x + 1;
                int[] corners = {c - side - 1, c - side, c, c - side - 1, c, c - 1};
                for (int k = 0; k < 6; k++)
                    obj.append(k % 3 == 0 ? "\nf" : "").append(" " + corners[k] + "/" + corners[k]);
            }
        }
        Path source = Files.createDirectory(folder.resolve("source"));
        BufferedImage image = new BufferedImage(64, 64, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 64 * 64; i++)
            image.setRGB(i % 64, i / 64, (i / 8 + i / 512 & 1) == 0 ? 0xd0b080 : 0x204060 + i % 64);
        ImageIO.write(image, "png", source.resolve("cloth.png").toFile());
        Files.writeString(source.resolve("grid.mtl"), "newmtl cloth\nmap_Kd cloth.png\n");
        Path grid = Files.writeString(source.resolve("grid.obj"), obj.append('\n'));
        Path model = models.resolve("grid.glb");
        ModelFiles.write(ModelFiles.read(grid).mesh(), model, ModelFormat.GLB);
        return model;
    }
}
