package org.jsmesh.store;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.FileVisitOption;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jsmesh.files.PathNames;
import org.jsmesh.mesh.io.ModelFormat;

/**
 * Finds the archives and model files of a folder and its sub-folders and gives each an id made from its file name.
 * Hidden files and folders are passed over, and those whose names the locale cannot hold. Where an archive and model
 * files differ only in their extension, the archive stands for them.
 */
final class FolderScan {
    static final String ARCHIVE = "jsm";
    private static final int MAX_DEPTH = 8;

    private final SortedMap<String, ModelEntry> entries = new TreeMap<>();
    private final Map<String, ModelEntry> others = new HashMap<>();
    private final List<FileSystemException> skipped;

    private FolderScan(List<FileSystemException> skipped) {
        this.skipped = skipped;
    }

    /** Looks for the models below {@code root} (or {@code root} itself when it is a file). */
    static FolderScan scan(Path root) throws IOException {
        List<Path> files = new ArrayList<>();
        FolderScan scan = new FolderScan(new ArrayList<>());
        if (Files.isRegularFile(root)) files.add(root);
        else collect(root, files, scan.skipped);
        Collections.sort(files);
        scan.identify(root, withoutSourcesOfArchives(files));
        return scan;
    }

    /** A folder in which nothing was found. */
    static FolderScan none() {
        return new FolderScan(List.of());
    }

    /** The models by their ids. */
    SortedMap<String, ModelEntry> entries() {
        return Collections.unmodifiableSortedMap(entries);
    }

    /** The model of that id, or of a further id that leads to it; null when there is none. */
    ModelEntry find(String id) {
        ModelEntry entry = entries.get(id);
        return entry == null ? others.get(id) : entry;
    }

    /** What was passed over because of its name, and why. */
    List<FileSystemException> skipped() {
        return skipped;
    }

    private static void collect(Path root, List<Path> files, List<FileSystemException> skipped) throws IOException {
        if (!Files.isDirectory(root)) throw new NoSuchFileException(root.toString());
        Files.walkFileTree(root, EnumSet.noneOf(FileVisitOption.class), MAX_DEPTH, new SimpleFileVisitor<>() {
            @Override
            public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
                boolean isSkipped = !folder.equals(root) && (isHidden(folder) || !isNameable(folder));
                return isSkipped ? FileVisitResult.SKIP_SUBTREE : FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
                boolean wanted = SourceStamp.extension(file).equals(ARCHIVE)
                        || ModelFormat.ofName(SourceStamp.fileName(file)) != null;
                if (wanted && !isHidden(file) && Files.isRegularFile(file) && isNameable(file)) files.add(file);
                return FileVisitResult.CONTINUE;
            }

            private boolean isNameable(Path path) {
                if (PathNames.areRepresentable(path)) return true;
                skipped.add(PathNames.skipped(path));
                return false;
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

    private void identify(Path root, List<Path> files) throws IOException {
        boolean isFile = Files.isRegularFile(root);
        ModelIds ids = ModelIds.of(files.stream()
                .map(file -> isFile ? SourceStamp.fileName(file) : PathNames.withSlashes(root.relativize(file)))
                .toList());
        List<ModelEntry> found = new ArrayList<>();
        for (Path file : files) {
            String id = ids.id(found.size());
            BasicFileAttributes attributes = Files.readAttributes(file, BasicFileAttributes.class);
            Instant modified = attributes.lastModifiedTime().toInstant().truncatedTo(ChronoUnit.SECONDS);
            String format = SourceStamp.extension(file);
            found.add(new ModelEntry(id, stem(file), file, format, attributes.size(), modified));
            entries.put(id, found.get(found.size() - 1));
        }
        ids.others().forEach((id, file) -> others.put(id, found.get(file)));
    }

    private static String stem(Path file) {
        String name = ModelFormat.withoutGzip(SourceStamp.fileName(file));
        int dot = name.lastIndexOf('.');
        return dot <= 0 ? name : name.substring(0, dot);
    }
}
