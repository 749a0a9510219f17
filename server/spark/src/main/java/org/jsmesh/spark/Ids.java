package org.jsmesh.spark;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.jsmesh.store.ids.ModelPath;

/**
 * Gives models of a catalogue the ids that {@link org.jsmesh.store.ids.ModelIds} gives them, without all of them in one
 * place. A file's id depends on the files that could have the same one alone, and these meet in two steps: first the
 * files with one short id, then those with one id after that.
 */
final class Ids {
    /**
     * A file with the id that it has so far.
     *
     * @param id that it has unless a better file has that
     * @param isOwner whether it is a short id, which nobody else gets
     * @param file as it was listed
     */
    record Given(String id, boolean isOwner, ListedModel file) implements java.io.Serializable {
        private static final long serialVersionUID = 1;
    }

    private static final Comparator<Given> BEST_FIRST = Comparator.comparing((Given g) -> !g.isOwner())
            .thenComparing(g -> ModelPath.of(g.file().place()), ModelPath.BEST_FIRST)
            .thenComparing(g -> g.file().input());

    private Ids() {}

    /** {@return what files must have in common to be in the first step's group} */
    static String first(ListedModel file) {
        ModelPath path = ModelPath.of(file.place());
        String id = path.shortId();
        return id != null ? id : path.longId(0);
    }

    /**
     * The first step.
     *
     * @param files with the same {@link #first}
     * @return the same files with ids
     */
    static List<Given> assign(Iterable<ListedModel> files) {
        List<ListedModel> sorted = new ArrayList<>();
        files.forEach(sorted::add);
        sorted.sort(Comparator.comparing((ListedModel f) -> ModelPath.of(f.place()), ModelPath.BEST_FIRST)
                .thenComparing(ListedModel::input));
        List<Given> given = new ArrayList<>();
        boolean isFree = true;
        for (ListedModel file : sorted) {
            ModelPath path = ModelPath.of(file.place());
            String id = path.shortId();
            boolean isOwner = id != null && isFree;
            if (isOwner) isFree = false;
            given.add(new Given(isOwner ? id : path.longId(0), isOwner, file));
        }
        return given;
    }

    /**
     * The second step.
     *
     * @param files with the same id
     * @return the same files with ids of their own, where the best has the common one
     */
    static List<Given> separate(Iterable<Given> files) {
        List<Given> sorted = new ArrayList<>();
        files.forEach(sorted::add);
        sorted.sort(BEST_FIRST);
        List<Given> separate = new ArrayList<>();
        for (int i = 0; i < sorted.size(); i++) {
            Given g = sorted.get(i);
            String id = i == 0 ? g.id() : ModelPath.of(g.file().place()).longId(i);
            separate.add(new Given(id, g.isOwner(), g.file()));
        }
        return separate;
    }
}
