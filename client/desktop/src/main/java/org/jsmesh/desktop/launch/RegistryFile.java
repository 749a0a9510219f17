package org.jsmesh.desktop.launch;

import java.util.List;
import java.util.stream.Collectors;

/** What the registry of Windows is told of the viewer, as a file that {@code reg.exe import} takes. */
final class RegistryFile {
    private static final String CLASSES = "HKEY_CURRENT_USER\\Software\\Classes\\";
    private static final String LINK = CLASSES + ModelLink.SCHEME;
    private static final String EXTENSION = CLASSES + ".jsm";
    private static final String FILE = CLASSES + "jSM.model";
    private static final String HEAD = "Windows Registry Editor Version 5.00\r\n";

    private RegistryFile() {}

    static String adding(StartCommand command) {
        String open = command(command.words());
        return HEAD
                + key(LINK, value("@", "URL:jSM model"), value("\"URL Protocol\"", ""))
                + key(LINK + "\\shell\\open\\command", value("@", open))
                + key(EXTENSION, value("@", "jSM.model"), value("\"Content Type\"", "model/vnd.jsm"))
                + key(FILE, value("@", "jSM model"))
                + key(FILE + "\\shell\\open\\command", value("@", open));
    }

    static String removing() {
        return HEAD + key("-" + LINK) + key("-" + EXTENSION) + key("-" + FILE);
    }

    /** What is opened is no option, whatever it begins with. */
    private static String command(List<String> words) {
        return words.stream().map(word -> '"' + word + '"').collect(Collectors.joining(" ", "", " -- \"%1\""));
    }

    private static String key(String path, String... values) {
        return "\r\n[" + path + "]\r\n" + String.join("", values);
    }

    private static String value(String name, String text) {
        return name + "=\"" + text.replace("\\", "\\\\").replace("\"", "\\\"") + "\"\r\n";
    }
}
