package org.jsmesh.desktop.launch;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** Writes into the part of the registry that belongs to the user. */
final class WindowsHandler extends LinkHandler {
    private static final char BYTE_ORDER = '\ufeff';

    @Override
    String register(StartCommand command) throws IOException {
        take(RegistryFile.adding(command));
        return "jsm: links and .jsm files are opened with " + String.join(" ", command.words()) + " now.";
    }

    @Override
    public String unregister() throws IOException {
        take(RegistryFile.removing());
        return "jsm: links and .jsm files are no longer opened with this viewer.";
    }

    private static void take(String registry) throws IOException {
        Path file = Files.createTempFile("jsm-viewer", ".reg");
        try {
            Files.write(file, (BYTE_ORDER + registry).getBytes(StandardCharsets.UTF_16LE));
            Tool.run("reg.exe", "import", file.toString());
        } finally {
            Files.delete(file);
        }
    }
}
