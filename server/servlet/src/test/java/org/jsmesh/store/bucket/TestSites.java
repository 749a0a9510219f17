package org.jsmesh.store.bucket;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.StringJoiner;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.ArchiveReport;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.sandbox.ModelFilesEncoder;
import org.jsmesh.store.Archive;

/** Sites in folders, and stores that read them in small blocks. */
public final class TestSites {
    /** So small that an archive has many. */
    public static final int BLOCK_BYTES = 4096;

    private static final int SIDE = 60;

    private static byte[] archive;

    private TestSites() {}

    /** An archive of tens of thousands of bytes. */
    public static synchronized byte[] archive(Path scratch) throws Exception {
        if (archive == null) {
            Path model = Files.writeString(scratch.resolve("hills.off"), hills());
            Path file = scratch.resolve("hills.jsm");
            new ModelFilesEncoder(EncoderSettings.defaults()).encode(model, file, ProgressListener.NONE);
            archive = Files.readAllBytes(file);
        }
        return archive.clone();
    }

    private static String hills() {
        StringBuilder off = new StringBuilder("OFF\n" + SIDE * SIDE + " " + 2 * (SIDE - 1) * (SIDE - 1) + " 0\n");
        for (int i = 0; i < SIDE * SIDE; i++) {
            double height = Math.sin(i * 12.9898) * 43758.5453;
            off.append(i % SIDE + " " + i / SIDE + " " + (float) (height - Math.floor(height)) + "\n");
        }
        for (int y = 0; y < SIDE - 1; y++) {
            for (int x = 0; x < SIDE - 1; x++) {
                int a = y * SIDE + x;
                off.append("3 " + a + " " + (a + 1) + " " + (a + SIDE) + "\n");
                off.append("3 " + (a + 1) + " " + (a + SIDE + 1) + " " + (a + SIDE) + "\n");
            }
        }
        return off.toString();
    }

    /** Writes a model as {@code jsm encode --site} does; gives the hash of its archive. */
    public static String publish(Path site, String id, byte[] content) throws IOException {
        Path model = Files.createDirectories(site.resolve("m").resolve(id));
        Path file = Files.write(model.resolve("new.jsm"), content);
        try (Archive opened = Archive.open(file)) {
            ArchiveReport report = ArchiveReport.of(opened.header(), opened.sha256());
            Files.write(model.resolve(opened.sha256() + ".jsm"), content);
            Files.writeString(
                    model.resolve("manifest.json"),
                    report.toManifestJson(id, "The " + id, opened.sha256() + ".jsm", null));
            return opened.sha256();
        } finally {
            Files.delete(file);
        }
    }

    /** Writes the catalogue's only page. */
    public static void list(Path site, String... ids) throws IOException {
        StringJoiner rows = new StringJoiner(", ");
        for (String id : ids) rows.add("{\"id\": \"" + id + "\", \"manifestUrl\": \"" + id + "/manifest.json\"}");
        Path index = Files.createDirectories(site.resolve("m")).resolve("index.json");
        Path whole = Files.write(
                index.resolveSibling("index.new"),
                ("{\"total\": " + ids.length + ", \"models\": [" + rows + "]}").getBytes(StandardCharsets.UTF_8));
        Files.move(whole, index, java.nio.file.StandardCopyOption.REPLACE_EXISTING);
    }

    public static SiteStore open(ObjectStore objects, SiteSettings settings, long readMillis) throws IOException {
        return SiteStore.open(objects, settings, readMillis, BLOCK_BYTES);
    }
}
