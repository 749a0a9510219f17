package org.jsmesh.web.build;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Stream;

/** Trees of files, in an order that does not depend on the machine. */
final class Folders {
    private Folders() {}

    /** The files in it at any depth; none when there is no such folder. */
    static List<Path> files(Path folder) throws IOException {
        if (!Files.isDirectory(folder)) return List.of();
        try (Stream<Path> walk = Files.walk(folder)) {
            return walk.filter(Files::isRegularFile)
                    .sorted(Comparator.comparing(file -> relative(folder, file)))
                    .toList();
        }
    }

    /** Path with slashes. */
    static String relative(Path folder, Path file) {
        return folder.relativize(file).toString().replace('\\', '/');
    }

    static void clear(Path folder) throws IOException {
        if (!Files.exists(folder)) return;
        List<Path> all;
        try (Stream<Path> walk = Files.walk(folder)) {
            all = walk.sorted(Comparator.reverseOrder()).toList();
        }
        for (Path path : all) Files.delete(path);
    }

    /** Copies those files whose paths are wanted; the folders may be of different file systems. */
    static void copy(Path from, Path to, Predicate<String> wanted) throws IOException {
        for (Path file : files(from)) {
            String name = relative(from, file);
            if (!wanted.test(name)) continue;
            Path copy = to.resolve(name);
            Files.createDirectories(copy.getParent());
            Files.copy(file, copy);
        }
    }
}
