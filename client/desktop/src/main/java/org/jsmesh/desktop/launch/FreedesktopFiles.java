package org.jsmesh.desktop.launch;

import java.util.List;
import java.util.stream.Collectors;

/** Texts by which desktops of Linux and the BSDs learn of the viewer (freedesktop.org). */
final class FreedesktopFiles {
    /** Of the entry, by which it is named in lists of programs. */
    static final String ENTRY = "jsm-viewer.desktop";

    static final String LINK_TYPE = "x-scheme-handler/" + ModelLink.SCHEME;
    static final String FILE_TYPE = "model/vnd.jsm";

    private FreedesktopFiles() {}

    /** @param script path of what starts the viewer */
    static String entry(String script) {
        return """
                [Desktop Entry]
                Type=Application
                Version=1.0
                Name=jSM viewer
                Comment=Shows streaming meshes while they refine
                Terminal=false
                Categories=Graphics;3DGraphics;Viewer;
                """ + "MimeType=" + LINK_TYPE + ";" + FILE_TYPE + ";\nExec=" + quoted(script) + " %u\n";
    }

    /**
     * A word of Exec. Old versions of xdg-open take quotes for a part of the word, so they stand only where they must.
     */
    private static String quoted(String word) {
        String literal = word.replace("%", "%%");
        if (literal.matches("[A-Za-z0-9/._+:@%-]+")) return literal;
        // Escaped once as a quoted word, and again as a value of the file.
        return '"' + literal.replaceAll("[\"`$\\\\]", "\\\\$0").replace("\\", "\\\\") + '"';
    }

    /** What is opened is no option, whatever it begins with. */
    static String script(List<String> command) {
        String words = command.stream()
                .map(word -> '\'' + word.replace("'", "'\\''") + '\'')
                .collect(Collectors.joining(" "));
        return "#!/bin/sh\n# Written by jsm-viewer --register.\nexec " + words + " -- \"$@\"\n";
    }

    /** Says by its name what a file of ours is. */
    static String types() {
        return """
                <?xml version="1.0" encoding="UTF-8"?>
                <mime-info xmlns="http://www.freedesktop.org/standards/shared-mime-info">
                  <mime-type type="model/vnd.jsm">
                    <comment>streaming mesh</comment>
                    <glob pattern="*.jsm"/>
                  </mime-type>
                </mime-info>
                """;
    }

    /**
     * A list of default programs without ours.
     *
     * @param list text of a {@code mimeapps.list}
     */
    static String without(String list) {
        StringBuilder kept = new StringBuilder();
        for (String line : list.lines().toList()) {
            int equals = line.indexOf('=');
            String key = equals < 0 ? "" : line.substring(0, equals).strip();
            if (!key.equals(LINK_TYPE) && !key.equals(FILE_TYPE)) {
                kept.append(line).append('\n');
                continue;
            }
            String others = List.of(line.substring(equals + 1).split(";")).stream()
                    .map(String::strip)
                    .filter(program -> !program.isEmpty() && !program.equals(ENTRY))
                    .collect(Collectors.joining(";"));
            if (!others.isEmpty()) kept.append(key).append('=').append(others).append(";\n");
        }
        return kept.toString();
    }
}
