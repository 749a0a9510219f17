package org.jsmesh.app;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.FileSystemNotFoundException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import org.jsmesh.app.console.CommandFailure;
import org.jsmesh.servlet.ViewerJar;
import picocli.CommandLine.Option;

/** The desktop viewer that {@code jsm serve} lets visitors start. A mixin. */
final class ViewerOption {
    private static final String NAME = "jsm-viewer.jar";

    @Option(
            names = "--viewer-jar",
            paramLabel = "FILE",
            description = {
                "The desktop viewer, signed, for visitors who start it from the page.",
                "Default: jsm-viewer.jar beside jsm.jar, if it is there and signed."
            })
    private Path jar;

    /** The viewer; null where there is none. */
    ViewerJar open() throws CommandFailure {
        if (jar == null) return beside(program());
        try {
            return ViewerJar.open(jar);
        } catch (IOException e) {
            throw new CommandFailure("--viewer-jar", e);
        }
    }

    /**
     * A viewer that nobody has named.
     *
     * @param program jar of this command, or null
     * @return the viewer beside it; null where there is none, or none that can be started
     */
    static ViewerJar beside(Path program) {
        if (program == null || !Files.isRegularFile(program.resolveSibling(NAME))) return null;
        try {
            return ViewerJar.open(program.resolveSibling(NAME));
        } catch (IOException e) {
            return null; // somebody keeps it there to start it by hand
        }
    }

    /** The jar that this command was started from; null when it was not. */
    private static Path program() {
        CodeSource source = ViewerOption.class.getProtectionDomain().getCodeSource();
        try {
            Path place = source == null ? null : Path.of(source.getLocation().toURI());
            return place == null || !Files.isRegularFile(place) ? null : place;
        } catch (URISyntaxException | IllegalArgumentException | FileSystemNotFoundException e) {
            return null;
        }
    }
}
