package org.jsmesh.web.build;

import java.nio.file.Path;

/**
 * Where the build reads and writes.
 *
 * @param sources of the page
 * @param decoder what was compiled of the decoder; the folder may be missing
 * @param work for intermediate files
 * @param output what is served
 */
record Layout(Path sources, Path decoder, Path work, Path output) {
    /** The folder of the files that are named after their content. */
    Path viewer() {
        return output.resolve("viewer");
    }
}
