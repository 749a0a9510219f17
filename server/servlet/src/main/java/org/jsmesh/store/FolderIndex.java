package org.jsmesh.store;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import org.jsmesh.store.ids.ModelPath;

/**
 * The models of a folder by their ids, kept up file by file. After any changes it holds what
 * {@link org.jsmesh.store.ids.ModelIds} gives for the files that are there, while a change of one file looks only at
 * those that share an id with it. Where an archive and model files differ only in their extension, the archive stands
 * for them. Thread-safe; finding waits for nobody.
 */
final class FolderIndex {
    static final String ARCHIVE = "jsm";

    private final Path folder;
    private final Listener listener;
    private final TreeMap<String, FolderFile> files = new TreeMap<>();
    private final Claims claims = new Claims();
    private final ConcurrentHashMap<String, FolderFile> owners = new ConcurrentHashMap<>();
    private final Map<String, String> formats = new HashMap<>();
    private final Map<FolderFile, Names> known = new HashMap<>();

    /** Files whose long ids are others', with the number of letters that theirs have more. */
    private final Map<FolderFile, Integer> displaced = new HashMap<>();

    /** Is told of changes one by one, in their order. */
    interface Listener {
        /** @param entry null when no model has the id any more */
        void changed(String id, ModelEntry entry);
    }

    FolderIndex(Path folder, Listener listener) {
        this.folder = folder;
        this.listener = listener;
    }

    /** The model of that id, or of a further id that leads to it; null when there is none. */
    ModelEntry find(String id) {
        ModelEntry entry = get(id);
        if (entry != null || id.isEmpty()) return entry;
        FolderFile only = null;
        for (FolderFile file : claims.of(id)) {
            if (!file.path().otherIds().contains(id)) continue;
            if (only != null) return null; // it would mean two models
            only = file;
        }
        return only == null ? null : only.entry;
    }

    /** The model of that very id; null when there is none. */
    ModelEntry get(String id) {
        FolderFile file = owners.get(id);
        return file == null ? null : file.entry;
    }

    /** The model of the file at that place; null when there is none. */
    synchronized ModelEntry at(String place) {
        FolderFile file = files.get(place);
        return file == null ? null : file.entry;
    }

    synchronized boolean has(String place) {
        return files.containsKey(place);
    }

    /** Models whose files' names, without extension, become that id, see {@link ModelEntry#idOf}. */
    List<ModelEntry> named(String id) {
        List<ModelEntry> named = new ArrayList<>(spelled(id));
        if (id.equals(ModelEntry.idOf(""))) named.addAll(spelled(""));
        return named;
    }

    private List<ModelEntry> spelled(String text) {
        return claims.of(text).stream()
                .filter(file -> file.path().stem().text().equals(text))
                .map(file -> file.entry)
                .filter(Objects::nonNull)
                .toList();
    }

    /** The places of all files of a folder and of those below it. */
    synchronized List<String> below(String place) {
        // A slash is followed by the digit 0.
        Map<String, FolderFile> part = place.isEmpty() ? files : files.subMap(place + "/", place + "0");
        return List.copyOf(part.keySet());
    }

    /** The places of the files that lie in a folder itself. */
    synchronized List<String> in(String place) {
        int start = place.isEmpty() ? 0 : place.length() + 1;
        List<String> in = new ArrayList<>();
        for (String file : below(place)) if (file.indexOf('/', start) < 0) in.add(file);
        return in;
    }

    /** A file is there, new or changed or as before. */
    synchronized void put(String place, long bytes, long modifiedSeconds) {
        FolderFile file = files.get(place);
        if (file != null && file.bytes == bytes && file.modifiedSeconds == modifiedSeconds) return;
        boolean isNew = file == null;
        if (isNew) files.put(place, file = new FolderFile(place));
        file.bytes = bytes;
        file.modifiedSeconds = modifiedSeconds;
        if (isNew) arrange(place, new LinkedHashSet<>());
        else if (file.entry != null) identify(file, file.entry.id());
    }

    /** A file is gone, if it ever was there. */
    synchronized void remove(String place) {
        FolderFile file = files.remove(place);
        if (file == null) return;
        Set<String> contested = new LinkedHashSet<>();
        if (file.entry != null) leave(file, contested);
        arrange(place, contested);
    }

    /** Decides anew which files of one name count, then who has the ids that were theirs or may be. */
    private void arrange(String place, Set<String> contested) {
        Collection<FolderFile> same = siblings(place);
        boolean isArchived = same.stream().anyMatch(f -> extension(f.place).equals(ARCHIVE));
        for (FolderFile file : same) {
            boolean counts = !isArchived || extension(file.place).equals(ARCHIVE);
            if (counts && file.entry == null) join(file, contested);
            else if (!counts && file.entry != null) leave(file, contested);
        }
        settle(contested);
    }

    /** Files that differ in their extension alone. */
    private Collection<FolderFile> siblings(String place) {
        int name = place.lastIndexOf('/') + 1;
        String stem = place.substring(0, name) + ModelPath.stem(place.substring(name));
        List<FolderFile> siblings = new ArrayList<>();
        // A point is followed by the slash, which no name holds.
        for (FolderFile file : files.subMap(stem + ".", stem + "/").values()) {
            if (stem.length()
                    == name + ModelPath.stem(file.place.substring(name)).length()) siblings.add(file);
        }
        FolderFile bare = files.get(stem);
        if (bare != null) siblings.add(bare);
        return siblings;
    }

    private void join(FolderFile file, Set<String> contested) {
        Names names = names(file);
        for (String id : names.all()) claims.add(id, file);
        // Its own id is settled below; until then nobody finds it.
        file.entry = entry(file, names.longId());
        contest(names, contested);
    }

    private void leave(FolderFile file, Set<String> contested) {
        Names names = names(file);
        String id = file.entry.id();
        displace(file, 0);
        for (String name : names.all()) claims.remove(name, file);
        file.entry = null;
        contest(names, contested);
        if (owners.remove(id, file)) listener.changed(id, null);
    }

    private static void contest(Names names, Set<String> contested) {
        if (names.shortId() != null) contested.add(names.shortId());
        contested.add(names.longId());
    }

    /** Gives out ids that files may want, and the long ones of those who do not get them. */
    private void settle(Set<String> contested) {
        Set<String> longIds = new LinkedHashSet<>(contested);
        for (String id : contested) {
            for (FolderFile file : claims.of(id)) {
                boolean mayChange = id.equals(names(file).shortId()) || displaced.containsKey(file);
                if (mayChange) longIds.add(names(file).longId());
            }
            FolderFile owner = shortOwner(id);
            if (owner == null) continue;
            displace(owner, 0);
            identify(owner, id);
        }
        longIds.forEach(this::settleLong);
        known.clear();
    }

    /** Who of the files whose short id it is has it; null when it is nobody's. */
    private FolderFile shortOwner(String id) {
        FolderFile owner = null;
        for (FolderFile file : claims.of(id)) {
            if (!id.equals(names(file).shortId())) continue;
            boolean isBetter = owner == null || ModelPath.BEST_FIRST.compare(names(file).path, names(owner).path) < 0;
            if (isBetter) owner = file;
        }
        return owner;
    }

    /** Gives files of one long id each an id of its own, the best of them first. */
    private void settleLong(String id) {
        List<FolderFile> wanting = new ArrayList<>();
        for (FolderFile file : claims.of(id)) {
            Names names = names(file);
            boolean wants = names.longId().equals(id);
            if (wants && (names.shortId() == null || shortOwner(names.shortId()) != file)) wanting.add(file);
        }
        wanting.sort(Comparator.comparing(file -> names(file).path, ModelPath.BEST_FIRST));
        Set<String> taken = new HashSet<>();
        for (FolderFile file : wanting) {
            int more = 0;
            String own = id;
            while (shortOwner(own) != null || isOf(own, more, wanting) || !taken.add(own))
                own = names(file).path.longId(++more);
            displace(file, more);
            identify(file, own);
        }
    }

    /** Lets the file claim the ids that it would have if others did not have them. */
    private void displace(FolderFile file, int more) {
        int before = displaced.getOrDefault(file, 0);
        if (before == more) return;
        ModelPath path = names(file).path;
        for (int i = before + 1; i <= more; i++) claims.add(path.longId(i), file);
        for (int i = more + 1; i <= before; i++) claims.remove(path.longId(i), file);
        if (more == 0) displaced.remove(file);
        else displaced.put(file, more);
    }

    /** Whether a file of another long id has it, which takes two hashes that begin alike. */
    private boolean isOf(String id, int more, List<FolderFile> wanting) {
        FolderFile owner = more == 0 ? null : owners.get(id);
        return owner != null && !wanting.contains(owner);
    }

    private Names names(FolderFile file) {
        return known.computeIfAbsent(file, f -> new Names(f.path()));
    }

    /** What ids a file may have, worked out once in a change. */
    private static final class Names {
        final ModelPath path;
        private final String shortId;
        private final Set<String> others;

        Names(ModelPath path) {
            this.path = path;
            shortId = path.shortId();
            others = path.otherIds();
        }

        String shortId() {
            return shortId;
        }

        String longId() {
            return others.iterator().next();
        }

        Set<String> all() {
            Set<String> all = new LinkedHashSet<>(others);
            if (shortId != null) all.add(shortId);
            return all;
        }
    }

    private void identify(FolderFile file, String id) {
        ModelEntry before = file.entry;
        ModelEntry now = entry(file, id);
        boolean isOwner = owners.get(id) == file;
        if (isOwner && now.equals(before)) return;
        file.entry = now;
        // First the new id, so that the file is found all the time.
        owners.put(id, file);
        listener.changed(id, now);
        if (!before.id().equals(id) && owners.remove(before.id(), file)) listener.changed(before.id(), null);
    }

    private ModelEntry entry(FolderFile file, String id) {
        String format = formats.computeIfAbsent(extension(file.place), same -> same);
        return new ModelEntry(id, folder, file.place, format, file.bytes, file.modifiedSeconds);
    }

    /** The file's extension in lower case, empty when it has none. */
    static String extension(String place) {
        String name = place.substring(place.lastIndexOf('/') + 1);
        int dot = name.lastIndexOf('.');
        return dot < 0 ? "" : name.substring(dot + 1).toLowerCase(Locale.ROOT);
    }
}
