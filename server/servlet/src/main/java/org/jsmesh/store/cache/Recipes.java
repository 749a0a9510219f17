package org.jsmesh.store.cache;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.function.Predicate;
import org.jsmesh.files.AtomicFiles;
import org.jsmesh.files.ModelInputs;

/**
 * Which inputs gave which archive: a file for each model content and settings, named by their hashes, with a row for
 * each state of the companions. Rows say what an encoding really read, so no file that was replaced meanwhile passes
 * for another. A file that cannot be read is as good as none.
 */
final class Recipes {
    private static final String ENDING = ".json";
    private static final int MOST_ROWS = 8;
    private static final ObjectMapper JSON = new ObjectMapper();

    /**
     * What was made of what.
     *
     * @param inputs that were read
     * @param sha256 of the archive
     */
    record Recipe(ModelInputs inputs, String sha256) {}

    private final Path folder;

    Recipes(Path folder) {
        this.folder = folder;
    }

    private Path file(String modelSha256, String settings) {
        try {
            byte[] hash = MessageDigest.getInstance("SHA-256").digest(settings.getBytes(StandardCharsets.UTF_8));
            return folder.resolve(modelSha256 + "-" + HexFormat.of().formatHex(hash, 0, 6) + ENDING);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }

    /** The rows for a model file with that content, last written first. */
    List<Recipe> of(String modelSha256, String settings) throws IOException {
        return read(file(modelSha256, settings));
    }

    /** Adds a row. */
    void add(ModelInputs inputs, String settings, String sha256) throws IOException {
        Path file = file(inputs.modelSha256(), settings);
        List<Recipe> rows = new ArrayList<>(List.of(new Recipe(inputs, sha256)));
        for (Recipe row : read(file)) {
            if (rows.size() < MOST_ROWS && !row.inputs().equals(inputs)) rows.add(row);
        }
        ArrayNode all = JSON.createArrayNode();
        for (Recipe row : rows)
            all.addObject()
                    .put("archive", row.sha256())
                    .set("inputs", JSON.readTree(row.inputs().toJson()));
        AtomicFiles.write(file, JSON.writeValueAsBytes(all));
    }

    private static List<Recipe> read(Path file) throws IOException {
        List<Recipe> rows = new ArrayList<>();
        try {
            for (JsonNode row : JSON.readTree(Files.readAllBytes(file))) {
                String sha256 = row.path("archive").asText();
                if (sha256.matches("[0-9a-f]{64}"))
                    rows.add(new Recipe(ModelInputs.fromJson(row.path("inputs").toString()), sha256));
            }
        } catch (NoSuchFileException | JsonProcessingException e) {
            return List.of();
        }
        return rows;
    }

    /** Removes the files whose archives are all gone. */
    void prune(Predicate<String> isKept) throws IOException {
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, "*" + ENDING)) {
            for (Path file : files)
                if (read(file).stream().noneMatch(row -> isKept.test(row.sha256()))) Files.deleteIfExists(file);
        }
    }
}
