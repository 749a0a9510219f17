package org.jsmesh.store;

import java.io.IOException;
import java.nio.file.FileVisitOption;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.text.Normalizer;
import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jsmesh.mesh.io.ModelFormat;

/**
 * Finds the archives and model files of a folder and its sub-folders and gives each an id made from its file name.
 * Hidden files and folders are passed over. Where an archive and model files differ only in their extension, the
 * archive stands for them.
 */
final class FolderScan {
    static final String ARCHIVE = "jsm";
    private static final int MAX_DEPTH = 8;

    private FolderScan() {}

    /** The models below {@code root} (or {@code root} itself when it is a file) by id. */
    static SortedMap<String, ModelEntry> scan(Path root) throws IOException {
        List<Path> files = new ArrayList<>();
        if (Files.isRegularFile(root)) files.add(root);
        else collect(root, files);
        Collections.sort(files);
        return identify(root, withoutSourcesOfArchives(files));
    }

    private static void collect(Path root, List<Path> files) throws IOException {
        if (!Files.isDirectory(root)) throw new NoSuchFileException(root.toString());
        Files.walkFileTree(root, EnumSet.noneOf(FileVisitOption.class), MAX_DEPTH, new SimpleFileVisitor<>() {
            @Override
            public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
                return !folder.equals(root) && isHidden(folder)
                        ? FileVisitResult.SKIP_SUBTREE
                        : FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
                boolean wanted = SourceStamp.extension(file).equals(ARCHIVE)
                        || ModelFormat.ofName(SourceStamp.fileName(file)) != null;
                if (wanted && !isHidden(file) && Files.isRegularFile(file)) files.add(file);
                return FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult visitFileFailed(Path file, IOException e) {
                // One unreadable folder must not hide the others.
                return FileVisitResult.CONTINUE;
            }
        });
    }

    private static boolean isHidden(Path path) {
        return SourceStamp.fileName(path).startsWith(".");
    }

    private static List<Path> withoutSourcesOfArchives(List<Path> files) {
        Set<Path> archived = new HashSet<>();
        for (Path file : files) {
            if (SourceStamp.extension(file).equals(ARCHIVE)) archived.add(file.resolveSibling(stem(file)));
        }
        List<Path> kept = new ArrayList<>(files);
        kept.removeIf(f -> !SourceStamp.extension(f).equals(ARCHIVE) && archived.contains(f.resolveSibling(stem(f))));
        return kept;
    }

    private static SortedMap<String, ModelEntry> identify(Path root, List<Path> files) throws IOException {
        Map<String, Integer> uses = new HashMap<>();
        for (Path file : files) uses.merge(slug(stem(file)), 1, Integer::sum);
        SortedMap<String, ModelEntry> entries = new TreeMap<>();
        for (Path file : files) {
            String id = slug(stem(file));
            // If several files have one name, none gets the plain id, so that a new file never takes over the id of
            // another.
            if (uses.get(id) > 1)
                id = slug(
                        Files.isRegularFile(root)
                                ? SourceStamp.fileName(file)
                                : root.relativize(file).toString());
            String unique = id;
            for (int n = 2; entries.containsKey(unique); n++) unique = id + "-" + n;
            entries.put(
                    unique, new ModelEntry(unique, stem(file), file, SourceStamp.extension(file), Files.size(file)));
        }
        return entries;
    }

    private static String stem(Path file) {
        String name = SourceStamp.fileName(file);
        int dot = name.lastIndexOf('.');
        return dot <= 0 ? name : name.substring(0, dot);
    }

    /** Lower-case ASCII letters and digits; runs of anything else become one hyphen. */
    static String slug(String text) {
        String plain = Normalizer.normalize(text, Normalizer.Form.NFKD).toLowerCase(Locale.ROOT);
        String slug =
                plain.replaceAll("\\p{M}+", "").replaceAll("[^a-z0-9]+", "-").replaceAll("^-|-$", "");
        return slug.isEmpty() ? "model" : slug;
    }
}
