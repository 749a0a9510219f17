package org.jsmesh.store;

import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Which files could have an id or lead from it. Most ids have one such file, which takes no collection of its own; a
 * name that a hundred thousand files have takes a set. One thread changes it at a time; others may read meanwhile.
 */
final class Claims {
    /** So many are kept in an array. */
    private static final int FEW = 8;

    /** For each id a {@link FolderFile}, a few in an array, or a set of them. */
    private final ConcurrentHashMap<String, Object> files = new ConcurrentHashMap<>();

    void add(String id, FolderFile file) {
        files.merge(id, file, (before, one) -> {
            if (before instanceof Set<?> set) {
                asFiles(set).add(file);
                return set;
            }
            FolderFile[] few = before instanceof FolderFile[] some ? some : new FolderFile[] {(FolderFile) before};
            if (few.length == FEW) {
                Set<FolderFile> many = ConcurrentHashMap.newKeySet();
                many.addAll(List.of(few));
                many.add(file);
                return many;
            }
            FolderFile[] more = Arrays.copyOf(few, few.length + 1);
            more[few.length] = file;
            return more;
        });
    }

    void remove(String id, FolderFile file) {
        files.computeIfPresent(id, (same, before) -> {
            if (before instanceof Set<?> set) {
                set.remove(file);
                return set.isEmpty() ? null : set;
            }
            FolderFile[] few = before instanceof FolderFile[] some ? some : new FolderFile[] {(FolderFile) before};
            FolderFile[] left = Arrays.stream(few).filter(f -> f != file).toArray(FolderFile[]::new);
            return left.length == 0 ? null : left.length == 1 ? left[0] : left;
        });
    }

    /** All files of that id, in no order. */
    Collection<FolderFile> of(String id) {
        Object found = files.get(id);
        if (found == null) return List.of();
        if (found instanceof Set<?> set) return asFiles(set);
        return found instanceof FolderFile[] few ? List.of(few) : List.of((FolderFile) found);
    }

    @SuppressWarnings("unchecked")
    private static Set<FolderFile> asFiles(Set<?> set) {
        return (Set<FolderFile>) set;
    }
}
