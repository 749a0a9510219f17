package org.jsmesh.test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.jsmesh.mesh.io.ModelFormat;
import org.opentest4j.TestAbortedException;

/**
 * Model files to test with: the project's own in {@code models/}, and models of others, which the project does not
 * hold. Those lie in the folder that the system property {@code jsm.test.models} names, relative to the project, or
 * else in {@code shared/models} beside the project. Where that folder is missing, tests on models of others are skipped
 * and say so. Tests look for these by name: {@code Duck.glb} of Khronos' glTF samples, {@code fandisk.m} and
 * {@code cessna.m} of Hoppe's progressive meshes. All other files of a known format serve too, whatever their names.
 */
public final class SampleModels {
    private static final String PROPERTY = "jsm.test.models";

    private SampleModels() {}

    /** Every model file, the project's own first, in one order. */
    public static List<Path> all() {
        return Stream.of(own(), others()).flatMap(List::stream).toList();
    }

    /** The project's own model files. */
    public static List<Path> own() {
        return models(project().resolve("models"));
    }

    /** Model files of others. Says on stdout when there are none. */
    public static List<Path> others() {
        List<Path> found = models(othersFolder());
        if (found.isEmpty()) System.out.println("SKIPPED the models of others: " + missing("models"));
        return found;
    }

    /** One model file of others. Skips the test where it is missing. */
    public static Path other(String name) {
        Path file = othersFolder().resolve(name);
        if (Files.isRegularFile(file)) return file;
        System.out.println("SKIPPED a test on " + name + ": " + missing(name));
        throw new TestAbortedException(missing(name));
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

    private static Path othersFolder() {
        String named = System.getProperty(PROPERTY, "");
        if (named.isBlank()) return project().resolveSibling("shared").resolve("models");
        Path folder = project().resolve(named).normalize();
        if (Files.isDirectory(folder)) return folder;
        throw new IllegalArgumentException(
                PROPERTY + " names " + folder + ", which is no folder: name a folder of model files");
    }

    private static String missing(String what) {
        return "no " + what + " in " + othersFolder() + ": point -D" + PROPERTY + " at a folder that has them";
    }

    private static List<Path> models(Path folder) {
        if (!Files.isDirectory(folder)) return List.of();
        try (Stream<Path> walk = Files.walk(folder)) {
            return walk.filter(file -> ModelFormat.ofName(file.toString()) != null)
                    .sorted()
                    .toList();
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }
}
