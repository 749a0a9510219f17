package org.jsmesh.site;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jsmesh.files.EncodeJob;
import org.jsmesh.store.ModelEntry;

/** Gives models of a site the ids that the servlet would give them. */
final class SiteIds {
    private SiteIds() {}

    /**
     * Ids in the order of the jobs.
     *
     * @param folder of the jobs' outputs, which have the same places in it as the inputs have in theirs
     */
    static List<String> of(List<EncodeJob> jobs, Path folder) {
        Map<String, Integer> uses = new HashMap<>();
        for (EncodeJob job : jobs) uses.merge(ModelEntry.idOf(name(job)), 1, Integer::sum);
        List<String> ids = new ArrayList<>();
        Set<String> taken = new HashSet<>();
        for (EncodeJob job : jobs) {
            String id = ModelEntry.idOf(name(job));
            if (uses.get(id) > 1) {
                Path place = folder.relativize(job.output())
                        .resolveSibling(String.valueOf(job.input().getFileName()));
                id = ModelEntry.idOf(place.toString());
            }
            String unique = id;
            for (int n = 2; !taken.add(unique); n++) unique = id + "-" + n;
            ids.add(unique);
        }
        return ids;
    }

    /** The model's name for people: that of its file, without the extension. */
    static String name(EncodeJob job) {
        String file = String.valueOf(job.input().getFileName());
        int dot = file.lastIndexOf('.');
        return dot <= 0 ? file : file.substring(0, dot);
    }
}
