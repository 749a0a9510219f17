package org.jsmesh.desktop.launch;

import java.net.URISyntaxException;
import java.nio.file.FileSystemNotFoundException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.List;

/**
 * What starts the viewer that runs now, without arguments.
 *
 * @param words program and its first arguments
 */
record StartCommand(List<String> words) {
    StartCommand {
        words = List.copyOf(words);
    }

    /**
     * Of the package that the viewer was started from, else of its jar.
     *
     * @throws IllegalStateException when it was started from neither, as by a browser or a development tool
     */
    static StartCommand current() {
        String packaged = System.getProperty("jpackage.app-path");
        if (packaged != null) return new StartCommand(List.of(packaged));
        CodeSource source = StartCommand.class.getProtectionDomain().getCodeSource();
        Path jar = source == null ? null : jar(source);
        if (jar == null)
            throw new IllegalStateException(
                    "this viewer has no place of its own on this machine: download jsm-viewer.jar and start that");
        return new StartCommand(List.of(java(), "-jar", jar.toString()));
    }

    private static Path jar(CodeSource source) {
        try {
            Path place = Path.of(source.getLocation().toURI());
            return Files.isRegularFile(place) ? place.toAbsolutePath() : null;
        } catch (URISyntaxException | IllegalArgumentException | FileSystemNotFoundException e) {
            return null;
        }
    }

    private static String java() {
        Path folder = Path.of(System.getProperty("java.home"), "bin");
        Path withoutConsole = folder.resolve("javaw.exe");
        Path program = Files.exists(withoutConsole) ? withoutConsole : folder.resolve("java");
        return program.toString();
    }
}
