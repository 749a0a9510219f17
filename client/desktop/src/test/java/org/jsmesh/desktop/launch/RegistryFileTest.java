package org.jsmesh.desktop.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class RegistryFileTest {
    @Test
    void shouldOpenLinksAndFilesWithoutTakingThemForOptions() {
        String text = RegistryFile.adding(
                new StartCommand(List.of("C:\\Java 17\\bin\\javaw.exe", "-jar", "C:\\a\\jsm-viewer.jar")));
        String open =
                "@=\"\\\"C:\\\\Java 17\\\\bin\\\\javaw.exe\\\" \\\"-jar\\\" \\\"C:\\\\a\\\\jsm-viewer.jar\\\" -- \\\"%1\\\"\"";
        assertThat(text.split("\r\n", -1))
                .containsExactly(
                        "Windows Registry Editor Version 5.00",
                        "",
                        "[HKEY_CURRENT_USER\\Software\\Classes\\jsm]",
                        "@=\"URL:jSM model\"",
                        "\"URL Protocol\"=\"\"",
                        "",
                        "[HKEY_CURRENT_USER\\Software\\Classes\\jsm\\shell\\open\\command]",
                        open,
                        "",
                        "[HKEY_CURRENT_USER\\Software\\Classes\\.jsm]",
                        "@=\"jSM.model\"",
                        "\"Content Type\"=\"model/vnd.jsm\"",
                        "",
                        "[HKEY_CURRENT_USER\\Software\\Classes\\jSM.model]",
                        "@=\"jSM model\"",
                        "",
                        "[HKEY_CURRENT_USER\\Software\\Classes\\jSM.model\\shell\\open\\command]",
                        open,
                        "");
    }

    @Test
    void shouldTakeBackEveryKeyThatItAdds() {
        String added = RegistryFile.adding(new StartCommand(List.of("x")));
        String removed = RegistryFile.removing();
        for (String line : added.split("\r\n")) {
            if (!line.startsWith("[")) continue;
            String key = line.substring(1, line.length() - 1);
            assertThat(removed.split("\r\n"))
                    .anyMatch(r ->
                            r.startsWith("[-") && (key + "\\").startsWith(r.substring(2, r.length() - 1) + "\\"));
        }
    }
}
