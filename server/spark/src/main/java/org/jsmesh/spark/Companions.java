package org.jsmesh.spark;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jsmesh.mesh.io.CompanionPaths;
import org.jsmesh.mesh.io.Resource;
import org.jsmesh.mesh.io.ResourceResolver;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;

/**
 * Finds the companions of a model in its store, as {@link org.jsmesh.files.FolderResources} does in a folder: beside it
 * and below, by exact path, then whatever the case of letters, then by the last part. Remembers the version of each.
 */
final class Companions implements ResourceResolver {
    private static final long LARGEST = 1L << 28;

    /** Of larger folders only what is asked for by its exact path is found: to list them for each model takes hours. */
    private static final int MOST_NAMES = 100_000;

    /** Behind every character that a name can have. */
    private static final String LAST = new String(Character.toChars(Character.MAX_CODE_POINT));

    private final ObjectStore store;
    private final String folder;
    private final Map<String, List<String>> listings = new HashMap<>();
    private final SortedMap<String, CompanionTag> asked = new TreeMap<>();

    /** @param folder of the model: empty, or with a slash at its end */
    Companions(ObjectStore store, String folder) {
        this.store = store;
        this.folder = folder;
    }

    @Override
    public Optional<byte[]> find(String path) throws IOException {
        return locate(path).map(Resource::content);
    }

    @Override
    public Optional<Resource> locate(String path) throws IOException {
        Optional<StoredObject> found = look(path);
        if (found.isEmpty()) {
            asked.put(path, new CompanionTag(path, null, null));
            return Optional.empty();
        }
        StoredObject object = found.get();
        byte[] content = new byte[(int) object.bytes()];
        store.read(object, 0, ByteBuffer.wrap(content));
        String place = object.key().substring(folder.length());
        asked.put(path, new CompanionTag(path, place, object.tag()));
        return Optional.of(new Resource(place, content));
    }

    /** {@return what was asked for so far, found or not} */
    Collection<CompanionTag> asked() {
        return List.copyOf(asked.values());
    }

    /** {@return whether all of these are found again in the same version} */
    boolean have(Collection<CompanionTag> companions) throws IOException {
        for (CompanionTag companion : companions) {
            Optional<StoredObject> found = look(companion.asked());
            String place = found.map(o -> o.key().substring(folder.length())).orElse(null);
            String tag = found.map(StoredObject::tag).orElse(null);
            if (!companion.equals(new CompanionTag(companion.asked(), place, tag))) return false;
        }
        return true;
    }

    private Optional<StoredObject> look(String path) throws IOException {
        Optional<StoredObject> exact = inside(path.replace('\\', '/'));
        if (exact.isPresent()) return exact;
        Optional<String> other = CompanionPaths.match(path, this::names);
        return other.isPresent() ? inside(other.get()) : Optional.empty();
    }

    private Optional<StoredObject> inside(String path) throws IOException {
        String relative = normal(path);
        if (relative == null) return Optional.empty();
        try {
            return store.find(folder + relative).filter(o -> o.bytes() <= LARGEST);
        } catch (IllegalArgumentException e) {
            return Optional.empty(); // What no key can be.
        }
    }

    /** Null for what leads out of the folder, and for the folder itself. */
    private static String normal(String path) {
        if (path.startsWith("/")) return null;
        List<String> parts = new ArrayList<>();
        for (String part : path.split("/")) {
            if (part.isEmpty() || part.equals(".")) continue;
            if (!part.equals("..")) parts.add(part);
            else if (parts.isEmpty()) return null;
            else parts.remove(parts.size() - 1);
        }
        return parts.isEmpty() ? null : String.join("/", parts);
    }

    private List<String> names(String relative) throws IOException {
        List<String> known = listings.get(relative);
        if (known != null) return known;
        List<String> names = list(folder + (relative.isEmpty() ? "" : relative + "/"));
        listings.put(relative, names);
        return names;
    }

    /** Names of files and folders; of each folder one file is looked at, and the rest leapt over. */
    private List<String> list(String prefix) throws IOException {
        List<String> names = new ArrayList<>();
        String after = "";
        while (after != null && names.size() <= MOST_NAMES) {
            String[] leap = {null};
            store.list(prefix, after, object -> {
                String rest = object.key().substring(prefix.length());
                int slash = rest.indexOf('/');
                names.add(slash < 0 ? rest : rest.substring(0, slash));
                if (slash >= 0) leap[0] = prefix + rest.substring(0, slash + 1) + LAST;
                return slash < 0 && names.size() <= MOST_NAMES;
            });
            after = leap[0];
        }
        return names.size() > MOST_NAMES ? List.of() : names;
    }
}
