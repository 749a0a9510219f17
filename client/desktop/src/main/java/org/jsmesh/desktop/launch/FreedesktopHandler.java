package org.jsmesh.desktop.launch;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.jsmesh.files.AtomicFiles;

/** Writes the files of the user, and tells the tools of the desktop, where there are any. */
final class FreedesktopHandler extends LinkHandler {
    private static final String SET_DEFAULT = "xdg-mime";

    /** Folders below that of the user's data. */
    private static final String SCRIPTS = "jsm";

    private static final String ENTRIES = "applications";
    private static final String TYPES = "mime/packages";

    private final Path data;
    private final Path configuration;

    /**
     * @param data where programs of the user keep what they are, such as {@code ~/.local/share}
     * @param configuration of the user, such as {@code ~/.config}
     */
    FreedesktopHandler(Path data, Path configuration) {
        this.data = data;
        this.configuration = configuration;
    }

    static FreedesktopHandler ofUser() {
        Path home = Path.of(System.getProperty("user.home", "."));
        return new FreedesktopHandler(
                folder("XDG_DATA_HOME", home.resolve(".local/share")),
                folder("XDG_CONFIG_HOME", home.resolve(".config")));
    }

    private static Path folder(String variable, Path otherwise) {
        String value = System.getenv(variable);
        // Relative ones do not count, says the specification.
        return value == null || !Path.of(value).isAbsolute() ? otherwise : Path.of(value);
    }

    @Override
    String register(StartCommand command) throws IOException {
        if (!Tool.isThere(SET_DEFAULT)) throw new IOException(SET_DEFAULT + " is not on the PATH: install xdg-utils");
        for (String folder : List.of(SCRIPTS, ENTRIES, TYPES)) Files.createDirectories(data.resolve(folder));
        Files.writeString(script(), FreedesktopFiles.script(command.words()));
        if (!script().toFile().setExecutable(true, true)) throw new IOException(script() + " cannot be made a program");
        Files.writeString(entry(), FreedesktopFiles.entry(script().toString()));
        Files.writeString(types(), FreedesktopFiles.types());
        // Without the folder, some versions of the tool do not keep what they are told.
        Files.createDirectories(configuration);
        update();
        Tool.run(
                SET_DEFAULT, "default", FreedesktopFiles.ENTRY, FreedesktopFiles.LINK_TYPE, FreedesktopFiles.FILE_TYPE);
        return "jsm: links and .jsm files are opened with " + String.join(" ", command.words()) + " now (" + entry()
                + ").";
    }

    @Override
    public String unregister() throws IOException {
        for (Path file : List.of(entry(), script(), types())) Files.deleteIfExists(file);
        for (Path list : List.of(configuration.resolve("mimeapps.list"), data.resolve("applications/mimeapps.list"))) {
            if (!Files.exists(list)) continue;
            String before = Files.readString(list);
            String after = FreedesktopFiles.without(before);
            // It holds what other programs open, too.
            if (!after.equals(before)) AtomicFiles.write(list, after.getBytes(StandardCharsets.UTF_8));
        }
        update();
        return "jsm: links and .jsm files are no longer opened with this viewer.";
    }

    private void update() throws IOException {
        update("update-desktop-database", data.resolve("applications"));
        update("update-mime-database", data.resolve("mime"));
    }

    /** These only make what desktops look up faster to find. */
    private static void update(String tool, Path folder) throws IOException {
        if (Tool.isThere(tool) && Files.isDirectory(folder)) Tool.run(tool, folder.toString());
    }

    private Path script() {
        return data.resolve(SCRIPTS).resolve("open-with-jsm-viewer");
    }

    private Path entry() {
        return data.resolve(ENTRIES).resolve(FreedesktopFiles.ENTRY);
    }

    private Path types() {
        return data.resolve(TYPES).resolve("jsm-viewer.xml");
    }
}
