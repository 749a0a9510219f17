package org.jsmesh.files;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jsmesh.mesh.io.ModelFormat;

/**
 * What people wrote about places of a model, in a JSON file beside it: {@code chair.annotations.json} for
 * {@code chair.obj}. {@code docs/page.md} describes its format; the page looks at its members.
 */
public final class AnnotationFile {
    /** Last part of its address, which lies beside the manifest's. */
    public static final String NAME = "annotations.json";

    /** No file is larger. */
    public static final int MOST_BYTES = 1 << 20;

    private static final ObjectMapper JSON = new ObjectMapper();

    private AnnotationFile() {}

    /**
     * Looks for the annotations of a model.
     *
     * @param model a model file or archive
     * @return the file of its annotations, or null when there is none
     */
    public static Path beside(Path model) {
        Path name = model.getFileName();
        if (name == null) return null;
        String text = ModelFormat.withoutGzip(name.toString());
        int dot = text.lastIndexOf('.');
        Path file = model.resolveSibling((dot <= 0 ? text : text.substring(0, dot)) + "." + NAME);
        return Files.isRegularFile(file) ? file : null;
    }

    /**
     * Reads annotations.
     *
     * @param file of the annotations
     * @return its bytes as they are
     * @throws FileSystemException that says why, when the file is too large, or does not have a list of annotations
     * @throws IOException when it cannot be read
     */
    public static byte[] read(Path file) throws IOException {
        if (Files.size(file) > MOST_BYTES) {
            throw wrong(file, "is larger than " + MOST_BYTES + " bytes. Shorten the annotations");
        }
        byte[] bytes = Files.readAllBytes(file);
        JsonNode content;
        try {
            content = JSON.readTree(bytes);
        } catch (JsonProcessingException e) {
            int line = e.getLocation() == null ? 1 : e.getLocation().getLineNr();
            throw wrong(file, "is not JSON in line " + line + ". Correct it");
        }
        if (!content.path("annotations").isArray()) {
            throw wrong(file, "has no list \"annotations\". Write {\"annotations\": [...]}");
        }
        return bytes;
    }

    private static FileSystemException wrong(Path file, String reason) {
        return new FileSystemException(file.toString(), null, reason);
    }
}
