package org.jsmesh.site;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.jsmesh.files.EncodeJob;
import org.jsmesh.files.PathNames;
import org.jsmesh.store.ids.ModelIds;

/** Gives models of a site the ids that the servlet would give them. */
final class SiteIds {
    private SiteIds() {}

    /**
     * Ids in the order of the jobs.
     *
     * @param folder of the jobs' outputs, which have the same places in it as the inputs have in theirs
     */
    static List<String> of(List<EncodeJob> jobs, Path folder) {
        ModelIds ids = ModelIds.of(jobs.stream().map(job -> path(job, folder)).toList());
        return IntStream.range(0, jobs.size()).mapToObj(ids::id).toList();
    }

    /** The place that the model has among the others. */
    private static String path(EncodeJob job, Path folder) {
        Path archive = folder.relativize(job.output());
        return PathNames.withSlashes(
                archive.resolveSibling(String.valueOf(job.input().getFileName())));
    }

    /** The model's name for people: that of its file, without the extension. */
    static String name(EncodeJob job) {
        String file = String.valueOf(job.input().getFileName());
        int dot = file.lastIndexOf('.');
        return dot <= 0 ? file : file.substring(0, dot);
    }
}
