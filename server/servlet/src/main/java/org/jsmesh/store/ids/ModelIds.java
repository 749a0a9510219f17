package org.jsmesh.store.ids;

import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The ids of the models of a folder. They come from the paths of the files alone, never from an order.
 *
 * <ul>
 *   <li>A Latin name gives its letters and digits: {@code Big Chair.obj} is {@code big-chair}, and in a folder
 *       {@code kitchen--big-chair}.
 *   <li>Where several files of one folder would have that id, the best of them has it: one that is written as its id,
 *       then an archive, GLB, glTF, OBJ, PLY, 3MF, OFF, Hoppe, STL. Each other one has its long id, with format and a
 *       hash of its path: {@code big-chair-stl-k3x9q2}.
 *   <li>A name with letters beyond Latin always has a long id, with its own letters: {@code 椅子-obj-m4w7ya}.
 * </ul>
 *
 * So a file that comes or goes moves no model of another name, and none with a long id. Every file is also found under
 * its long id. Immutable.
 */
public final class ModelIds {
    private final List<ModelPath> files;
    private final List<String> ids;
    private final Map<String, Integer> others;

    private ModelIds(List<ModelPath> files) {
        this.files = files;
        ids = assign();
        others = otherIds();
    }

    /**
     * Gives every file an id.
     *
     * @param paths of the files in their folder, with slashes between folders; all different
     * @return the ids
     */
    public static ModelIds of(List<String> paths) {
        return new ModelIds(paths.stream().map(ModelPath::of).toList());
    }

    /**
     * Tells the id of a file.
     *
     * @param file its place in the list of paths
     * @return lower-case letters and digits of any script, and hyphens; at most 240 bytes of UTF-8; no other file's
     */
    public String id(int file) {
        return ids.get(file);
    }

    /**
     * Writes an id as a part of an address.
     *
     * @param id as this class gives it
     * @return the id with letters beyond ASCII percent-encoded as UTF-8
     */
    public static String segment(String id) {
        // All that ids hold is encoded there as in a path.
        return URLEncoder.encode(id, StandardCharsets.UTF_8);
    }

    /** Further ids that lead to a file: its long one, and those of earlier versions that mean no other file. */
    public Map<String, Integer> others() {
        return others;
    }

    private List<String> assign() {
        Map<String, ModelPath> owners = new HashMap<>();
        for (ModelPath file : files) {
            if (file.shortId() != null) owners.merge(file.shortId(), file, ModelIds::better);
        }
        Map<ModelPath, String> given = new HashMap<>();
        Set<String> taken = new HashSet<>(owners.keySet());
        for (ModelPath file : files.stream().sorted(ModelPath.BEST_FIRST).toList()) {
            String id = file.shortId();
            boolean isOwner = id != null && owners.get(id).equals(file);
            given.put(file, isOwner ? id : freeLongId(file, taken));
        }
        return files.stream().map(given::get).toList();
    }

    private static ModelPath better(ModelPath a, ModelPath b) {
        return ModelPath.BEST_FIRST.compare(a, b) <= 0 ? a : b;
    }

    private static String freeLongId(ModelPath file, Set<String> taken) {
        int more = 0;
        String id = file.longId(more);
        while (!taken.add(id)) id = file.longId(++more);
        return id;
    }

    private Map<String, Integer> otherIds() {
        Map<String, Integer> found = new HashMap<>();
        Set<String> ambiguous = new HashSet<>(ids);
        for (int i = 0; i < files.size(); i++) {
            for (String id : files.get(i).otherIds()) {
                if (id.isEmpty() || found.put(id, i) != null) ambiguous.add(id);
            }
        }
        found.keySet().removeAll(ambiguous);
        return Collections.unmodifiableMap(found);
    }
}
