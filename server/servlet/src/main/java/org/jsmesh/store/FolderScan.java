package org.jsmesh.store;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import org.jsmesh.files.PathNames;
import org.jsmesh.mesh.io.ModelFormat;

/**
 * Looks for archives and model files in a folder and its sub-folders and keeps an index to what is there: all of it,
 * one file, or the folders that files came to or went from. Hidden files and folders are passed over, and those whose
 * names the locale cannot hold. One thread looks at a time.
 */
final class FolderScan {
    private static final int MAX_DEPTH = 8;
    /** A folder may change again within one tick of the clock of its file system. */
    private static final long TICK_NANOS = 2_000_000_000L;

    private static final long UNSURE = Long.MIN_VALUE;

    private final Path root;
    private final FolderIndex index;
    private final Listener listener;

    /** Each folder with the time of its last change as it was when it was listed. */
    private final TreeMap<String, Long> folders = new TreeMap<>();

    /** Is told what is met on the way. */
    interface Listener {
        /** A folder is listed next. */
        void folder(String place, Path folder);

        /** A folder is gone, and those in it. */
        void gone(String place);

        /** What was passed over because of its name, and why. */
        void skipped(FileSystemException reason);
    }

    FolderScan(Path root, FolderIndex index, Listener listener) {
        this.root = root;
        this.index = index;
        this.listener = listener;
    }

    /** Looks at every file. */
    void all() throws IOException {
        BasicFileAttributes attributes = attributes(root);
        if (attributes.isDirectory()) list("", attributes, true);
        else if (attributes.isRegularFile()) put(SourceStamp.fileName(root), attributes);
        else throw new NotDirectoryException(root.toString());
    }

    /** Lists the folders again that files came to or went from since they were listed. */
    void changedFolders() throws IOException {
        BasicFileAttributes whole = attributes(root);
        if (!whole.isDirectory()) {
            all();
            return;
        }
        for (String place : List.copyOf(folders.keySet())) {
            Long listed = folders.get(place);
            if (listed == null) continue; // gone with the one around it
            BasicFileAttributes now = place.isEmpty() ? whole : attributesOf(place);
            if (now == null || !now.isDirectory()) forget(place);
            else if (listed == UNSURE || nanos(now) != listed) list(place, now, false);
        }
    }

    /** Looks for new and removed files of one folder. */
    void folder(String place) throws IOException {
        BasicFileAttributes now = folders.containsKey(place) ? attributesOf(place) : null;
        if (now != null && now.isDirectory()) list(place, now, false);
        else at(place);
    }

    /** Looks at one file or folder that may have come, changed or gone. */
    void at(String place) throws IOException {
        if (isHidden(place)) return;
        BasicFileAttributes attributes = attributesOf(place);
        if (attributes == null) {
            forget(place);
        } else if (attributes.isDirectory()) {
            index.remove(place);
            if (depth(place) < MAX_DEPTH) list(place, attributes, true);
        } else {
            forgetFolder(place);
            if (attributes.isRegularFile() && isWanted(place)) put(place, attributes);
            else index.remove(place);
        }
    }

    /** Those of a folder, or of the file or link itself; null when there is nothing that can be read. */
    private BasicFileAttributes attributesOf(String place) {
        try {
            Path path = path(place);
            BasicFileAttributes own = Files.readAttributes(path, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
            if (!own.isSymbolicLink()) return own;
            BasicFileAttributes target = attributes(path);
            // Links to folders could lead in circles.
            return target.isDirectory() ? null : target;
        } catch (IOException e) {
            return null;
        }
    }

    private void list(String place, BasicFileAttributes attributes, boolean everyFile) throws IOException {
        Path folder = path(place);
        listener.folder(place, folder);
        boolean isFresh = System.currentTimeMillis() * 1_000_000 - nanos(attributes) < TICK_NANOS;
        folders.put(place, isFresh ? UNSURE : nanos(attributes));
        Set<String> seen = new TreeSet<>();
        try (DirectoryStream<Path> paths = Files.newDirectoryStream(folder)) {
            for (Path path : paths) {
                String name = SourceStamp.fileName(path);
                if (isHidden(name) || !isNameable(path)) continue;
                String inner = place.isEmpty() ? name : place + '/' + name;
                seen.add(inner);
            }
        } catch (DirectoryIteratorException e) {
            throw e.getCause();
        } catch (AccessDeniedException | NoSuchFileException | NotDirectoryException e) {
            // One unreadable folder must not hide the others.
            if (place.isEmpty()) throw e;
        }
        // In order, so that models come to the list where it ends.
        for (String inner : seen) {
            boolean isKnown = folders.containsKey(inner) || index.has(inner);
            if (everyFile || !isKnown) at(inner);
        }
        for (String inner : index.in(place)) if (!seen.contains(inner)) index.remove(inner);
        for (String inner : List.copyOf(below(place).keySet())) {
            if (parent(inner).equals(place) && !seen.contains(inner)) forget(inner);
        }
    }

    private void put(String place, BasicFileAttributes attributes) {
        index.put(place, attributes.size(), attributes.lastModifiedTime().to(TimeUnit.SECONDS));
    }

    private boolean isNameable(Path path) {
        if (PathNames.areRepresentable(path)) return true;
        boolean isOfNote = isWanted(SourceStamp.fileName(path)) || Files.isDirectory(path, LinkOption.NOFOLLOW_LINKS);
        if (isOfNote) listener.skipped(PathNames.skipped(path));
        return false;
    }

    private void forget(String place) {
        index.remove(place);
        forgetFolder(place);
    }

    private void forgetFolder(String place) {
        if (folders.remove(place) == null) return;
        below(place).clear();
        index.below(place).forEach(index::remove);
        listener.gone(place);
    }

    private Map<String, Long> below(String place) {
        return place.isEmpty() ? folders.tailMap("", false) : folders.subMap(place + '/', place + '0');
    }

    private Path path(String place) {
        return place.isEmpty() ? root : root.resolve(place);
    }

    private static BasicFileAttributes attributes(Path file) throws IOException {
        return Files.readAttributes(file, BasicFileAttributes.class);
    }

    private static boolean isWanted(String place) {
        return FolderIndex.extension(place).equals(FolderIndex.ARCHIVE)
                || ModelFormat.ofName(place.substring(place.lastIndexOf('/') + 1)) != null;
    }

    private static boolean isHidden(String place) {
        return place.startsWith(".") || place.contains("/.");
    }

    static String parent(String place) {
        return place.substring(0, Math.max(0, place.lastIndexOf('/')));
    }

    private static int depth(String place) {
        return (int) place.chars().filter(c -> c == '/').count() + 1;
    }

    private static long nanos(BasicFileAttributes attributes) {
        return attributes.lastModifiedTime().to(TimeUnit.NANOSECONDS);
    }
}
