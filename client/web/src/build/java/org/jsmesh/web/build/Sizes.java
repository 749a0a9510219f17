package org.jsmesh.web.build;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;

/** How large the files are that are served, plain and packed. */
final class Sizes {
    private static final String LINE = "%9s %9s %9s  %s%n";

    /** -1 where there is no such file. */
    private record Size(String name, long plain, long gzip, long brotli) {}

    private final List<Size> sizes = new ArrayList<>();

    private Sizes() {}

    static Sizes of(Path folder, Collection<Path> files) throws IOException {
        Sizes all = new Sizes();
        for (Path file : files) {
            String name = Folders.relative(folder, file);
            all.sizes.add(new Size(name, Files.size(file), packed(file, ".gz"), packed(file, ".br")));
        }
        return all;
    }

    private static long packed(Path file, String suffix) throws IOException {
        Path packed = file.resolveSibling(file.getFileName() + suffix);
        return Files.exists(packed) ? Files.size(packed) : -1;
    }

    String toTable() {
        StringBuilder table = new StringBuilder(LINE.formatted("bytes", "gzip", "Brotli", "file"));
        for (Size size : sizes) {
            table.append(LINE.formatted(size.plain, text(size.gzip), text(size.brotli), size.name));
        }
        return table.toString();
    }

    private static String text(long bytes) {
        return bytes < 0 ? "" : Long.toString(bytes);
    }
}
