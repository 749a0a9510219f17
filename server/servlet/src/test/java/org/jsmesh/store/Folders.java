package org.jsmesh.store;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;

/** Folders that tests look at without watching them. */
final class Folders {
    private Folders() {}

    /** What one look at the folder, or at the file, finds. */
    static FolderIndex scan(Path root) throws IOException {
        FolderIndex index = new FolderIndex(base(root), (id, entry) -> {});
        scan(root, index).all();
        return index;
    }

    static FolderScan scan(Path root, FolderIndex index) {
        return new FolderScan(root, index, new FolderScan.Listener() {
            @Override
            public void folder(String place, Path folder) {}

            @Override
            public void gone(String place) {}

            @Override
            public void skipped(FileSystemException reason) {}
        });
    }

    static Path base(Path root) {
        return Files.isRegularFile(root) ? root.resolveSibling("") : root;
    }

    static SortedSet<String> ids(FolderIndex index) {
        return new TreeSet<>(entries(index).keySet());
    }

    /** The models by their ids. */
    static SortedMap<String, ModelEntry> entries(FolderIndex index) {
        SortedMap<String, ModelEntry> entries = new TreeMap<>();
        for (String place : index.below("")) {
            ModelEntry entry = index.at(place);
            if (entry != null) entries.put(entry.id(), entry);
        }
        return entries;
    }
}
