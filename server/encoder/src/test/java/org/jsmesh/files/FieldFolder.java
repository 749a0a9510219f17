package org.jsmesh.files;

import java.nio.file.Files;
import java.nio.file.Path;
import org.jsmesh.test.SampleModels;
import org.opentest4j.TestAbortedException;

/**
 * Inputs with one property each that real files have, which the project does not hold. They lie in the folder that the
 * system property {@code jsm.test.field} names, relative to the project, or else in {@code shared/field} beside the
 * project. Where that folder is missing, tests are skipped and say so.
 */
final class FieldFolder {
    private static final String PROPERTY = "jsm.test.field";

    private FieldFolder() {}

    /** A folder of inputs, which may be missing. */
    static Path place(String name) {
        Path project = SampleModels.project();
        String given = System.getProperty(PROPERTY);
        return (given == null ? project.resolveSibling("shared/field") : project.resolve(given)).resolve(name);
    }

    /** A folder of inputs. Skips the test where it is missing. */
    static Path of(String name) {
        Path folder = place(name);
        if (Files.isDirectory(folder)) return folder;
        String why = "there is no folder " + folder + "; -D" + PROPERTY + "=FOLDER names the folder above it";
        System.out.println("SKIPPED a test on inputs from the field: " + why);
        throw new TestAbortedException(why);
    }
}
