package org.jsmesh.test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Model files to test with: the project's own, and those of a folder {@code shared/models} beside the project where
 * there is one.
 */
public final class SampleModels {
    private static final Set<String> EXTENSIONS = Set.of("ply", "obj", "stl", "off", "m", "glb");

    private SampleModels() {}

    /** Every model file of both folders, in one order. Says on stdout when the folder beside the project is missing. */
    public static List<Path> all() {
        Path project = project();
        List<Path> files = new ArrayList<>(models(project.resolve("models")));
        Path shared = project.resolveSibling("shared").resolve("models");
        if (Files.isDirectory(shared)) files.addAll(models(shared));
        else System.out.println("SKIPPED the models of " + shared + ": there is no such folder");
        return files;
    }

    /** The folder that holds the project. */
    public static Path project() {
        Path folder = Path.of("").toAbsolutePath();
        while (folder != null
                && !(Files.isDirectory(folder.resolve("core")) && Files.isDirectory(folder.resolve("server"))))
            folder = folder.getParent();
        if (folder == null)
            throw new IllegalStateException(
                    "tests run outside the project: " + Path.of("").toAbsolutePath());
        return folder;
    }

    private static List<Path> models(Path folder) {
        if (!Files.isDirectory(folder)) return List.of();
        try (Stream<Path> walk = Files.walk(folder)) {
            return walk.filter(file -> EXTENSIONS.contains(extension(file)))
                    .sorted()
                    .toList();
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    private static String extension(Path file) {
        String name = file.getFileName().toString();
        return name.substring(name.lastIndexOf('.') + 1);
    }
}
