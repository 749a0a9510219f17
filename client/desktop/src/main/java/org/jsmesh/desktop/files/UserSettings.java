package org.jsmesh.desktop.files;

import java.io.IOException;
import java.io.StringReader;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Properties;
import org.jsmesh.files.AtomicFiles;

/**
 * What the viewer remembers of its user: what was opened last, the look, the folder of the last file. Kept in a small
 * text file, which is read again before each change, because other windows may have written it. Where it cannot be
 * written nothing is remembered beyond this run. Used on the event dispatch thread.
 */
public final class UserSettings {
    /** Locations that are remembered. */
    public static final int MOST_RECENT = 10;

    private static final int MOST_BYTES = 1 << 20;
    private static final String RECENT = "recent.";
    private static final String DARK = "dark";
    private static final String PANEL = "panel";
    private static final String FOLDER = "folder";

    private final Path file;
    private Properties values = new Properties();

    /** @param file need not exist; null remembers nothing beyond this run */
    public UserSettings(Path file) {
        this.file = file;
        read();
    }

    /** {@return those of this user, in the place that the operating system has for them} */
    public static UserSettings ofUser() {
        String system = System.getProperty("os.name", "").toLowerCase(Locale.ROOT);
        Path home = Path.of(System.getProperty("user.home", "."));
        return new UserSettings(base(system, home).resolve("jsm").resolve("viewer.properties"));
    }

    private static Path base(String system, Path home) {
        if (system.contains("mac")) return home.resolve("Library/Application Support");
        String variable = System.getenv(system.contains("win") ? "APPDATA" : "XDG_CONFIG_HOME");
        return variable == null || variable.isBlank() ? home.resolve(".config") : Path.of(variable);
    }

    /** {@return locations, the one opened last first, at most {@value #MOST_RECENT}} */
    public List<String> recent() {
        List<String> found = new ArrayList<>();
        for (int i = 0; i < MOST_RECENT; i++) {
            String location = values.getProperty(RECENT + i);
            if (location != null && !location.isBlank()) found.add(location);
        }
        return found;
    }

    /**
     * Puts a location before the others.
     *
     * @param location that was opened
     */
    public void opened(String location) {
        read();
        List<String> next = new ArrayList<>(recent());
        next.remove(location);
        next.add(0, location);
        setRecent(next);
    }

    /** Forgets all locations. */
    public void forgetRecent() {
        read();
        setRecent(List.of());
    }

    private void setRecent(List<String> locations) {
        for (int i = 0; i < MOST_RECENT; i++) {
            if (i < locations.size()) values.setProperty(RECENT + i, locations.get(i));
            else values.remove(RECENT + i);
        }
        write();
    }

    /** {@return whether windows are dark} */
    public boolean isDark() {
        return Boolean.parseBoolean(values.getProperty(DARK));
    }

    /** @param on whether windows are dark from now on */
    public void setDark(boolean on) {
        set(DARK, String.valueOf(on));
    }

    /** {@return whether the side panel is shown; true at first} */
    public boolean isPanelShown() {
        return !"false".equals(values.getProperty(PANEL));
    }

    /** @param on whether new windows show the side panel */
    public void setPanelShown(boolean on) {
        set(PANEL, String.valueOf(on));
    }

    /** {@return the folder of the last file, or null} */
    public Path folder() {
        String folder = values.getProperty(FOLDER);
        try {
            return folder == null || !Files.isDirectory(Path.of(folder)) ? null : Path.of(folder);
        } catch (java.nio.file.InvalidPathException e) {
            return null;
        }
    }

    /** @param used a file that was opened or saved */
    public void used(Path used) {
        Path folder = used.toAbsolutePath().getParent();
        if (folder != null) set(FOLDER, folder.toString());
    }

    private void set(String name, String value) {
        read();
        if (value.equals(values.setProperty(name, value))) return;
        write();
    }

    private void read() {
        if (file == null) return;
        Properties found = new Properties();
        try {
            if (!Files.isRegularFile(file) || Files.size(file) > MOST_BYTES) return;
            found.load(new StringReader(Files.readString(file, StandardCharsets.UTF_8)));
        } catch (IOException | IllegalArgumentException e) {
            return; // damaged or not to be read: what was known holds
        }
        values = found;
    }

    private void write() {
        if (file == null) return;
        StringWriter text = new StringWriter();
        try {
            values.store(text, "jSM viewer");
            AtomicFiles.write(file, text.toString().getBytes(StandardCharsets.UTF_8));
        } catch (IOException e) {
            // Remembered for this run alone.
        }
    }
}
