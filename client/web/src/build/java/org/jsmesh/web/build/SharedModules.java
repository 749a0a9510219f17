package org.jsmesh.web.build;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Modules that several files of a page share. The bundler makes a file for each set of files that share something: a
 * page would ask for many small ones. Where every file imports all of them, they are in one.
 *
 * @param entries sources of the files
 * @param modules sources that they share
 */
record SharedModules(List<String> entries, List<String> modules) {
    private static final String FILE = "shared.js";

    /** Writes the imports into the sources. */
    void gather(Path folder) throws IOException {
        StringBuilder imports = new StringBuilder();
        for (String module : modules)
            imports.append("import './").append(module).append("';\n");
        Files.writeString(folder.resolve(FILE), imports);
        for (String entry : entries) {
            Path file = folder.resolve(entry);
            String up = "../".repeat(file.getNameCount() - folder.getNameCount() - 1);
            String path = up.isEmpty() ? "./" + FILE : up + FILE;
            Files.writeString(file, "import '" + path + "';\n" + Files.readString(file));
        }
    }
}
