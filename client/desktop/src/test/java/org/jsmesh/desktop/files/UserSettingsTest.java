package org.jsmesh.desktop.files;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class UserSettingsTest {
    @TempDir
    private Path folder;

    @Test
    void shouldRememberWhatWasOpenedLast() {
        UserSettings settings = new UserSettings(file());
        assertThat(settings.recent()).isEmpty();
        for (int i = 0; i < 12; i++) settings.opened("http://h/ü " + i + ".jsm");
        settings.opened("http://h/ü 7.jsm");
        assertThat(new UserSettings(file()).recent())
                .hasSize(UserSettings.MOST_RECENT)
                .doesNotHaveDuplicates()
                .startsWith("http://h/ü 7.jsm", "http://h/ü 11.jsm")
                .endsWith("http://h/ü 2.jsm");
        settings.forgetRecent();
        assertThat(new UserSettings(file()).recent()).isEmpty();
    }

    @Test
    void shouldKeepWhatAnotherWindowHasWritten() {
        UserSettings one = new UserSettings(file());
        UserSettings other = new UserSettings(file());
        one.opened("a.jsm");
        other.opened("b.jsm");
        one.setDark(true);
        other.setPanelShown(false);
        UserSettings later = new UserSettings(file());
        assertThat(later.recent()).containsExactly("b.jsm", "a.jsm");
        assertThat(later.isDark()).isTrue();
        assertThat(later.isPanelShown()).isFalse();
    }

    @Test
    void shouldRememberTheFolderWhileItIsThere() throws IOException {
        UserSettings settings = new UserSettings(file());
        assertThat(settings.folder()).isNull();
        Path models = Files.createDirectory(folder.resolve("models"));
        settings.used(models.resolve("a.ply"));
        assertThat(settings.folder()).isEqualTo(models);
        Files.delete(models);
        assertThat(settings.folder()).isNull();
    }

    @Test
    void shouldLiveWithADamagedFileAndWithNone() throws IOException {
        Files.createDirectories(file().getParent());
        Files.writeString(file(), "dark=\\u12\n");
        assertThat(new UserSettings(file()).isDark()).isFalse();
        UserSettings nowhere = new UserSettings(null);
        nowhere.opened("a.jsm");
        assertThat(nowhere.recent()).containsExactly("a.jsm");
        Path blocked = Files.writeString(folder.resolve("file"), "").resolve("settings");
        UserSettings unwritable = new UserSettings(blocked);
        unwritable.setDark(true);
        assertThat(unwritable.isDark()).isTrue();
    }

    private Path file() {
        return folder.resolve("config").resolve("viewer.properties");
    }
}
