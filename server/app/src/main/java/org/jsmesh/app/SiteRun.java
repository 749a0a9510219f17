package org.jsmesh.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import org.jsmesh.app.console.CommandFailure;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.files.EncodeJob;
import org.jsmesh.files.EncodeResult;
import org.jsmesh.files.Explanation;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.ObjectStores;
import org.jsmesh.site.StaticSite;
import org.jsmesh.webapp.ViewerFiles;

/** One run of {@code jsm encode --site}. */
final class SiteRun implements AutoCloseable {
    private final String out;
    private final StaticSite site;

    private SiteRun(String out, StaticSite site) {
        this.out = out;
        this.site = site;
    }

    /**
     * Opens or begins a site.
     *
     * @param out path of its folder, or its address in a bucket
     * @param publicUrl address of the site, or null when it is not known
     */
    static SiteRun begin(String out, String publicUrl) throws CommandFailure {
        try {
            if (!ObjectStores.isRemote(out))
                return new SiteRun(
                        out, StaticSite.open(Path.of(out), ViewerFiles.read()).at(publicUrl));
            ObjectStore store = ObjectStores.open(out);
            try {
                return new SiteRun(
                        out, StaticSite.open(store, ViewerFiles.read()).at(publicUrl));
            } catch (IOException e) {
                store.close();
                throw e;
            }
        } catch (IllegalArgumentException e) {
            throw new CommandFailure(e.getMessage());
        } catch (IOException e) {
            throw new CommandFailure(out, e);
        }
    }

    /** The folder to encode to. */
    Path staging() {
        return site.staging();
    }

    /**
     * Puts the archives in their places and brings the rest of the site up to date.
     *
     * @param encoded results of the jobs whose inputs are no archives, in their order
     * @param prune whether to remove models that no job is for
     * @return the results of all jobs with the archives' places
     */
    List<EncodeResult> publish(List<EncodeJob> jobs, List<EncodeResult> encoded, boolean prune) throws CommandFailure {
        List<String> ids = site.ids(jobs);
        List<EncodeResult> published = new ArrayList<>();
        Iterator<EncodeResult> next = encoded.iterator();
        for (int i = 0; i < jobs.size(); i++) {
            EncodeJob job = jobs.get(i);
            published.add(publish(ids.get(i), job, isArchive(job) ? take(job) : next.next()));
        }
        try {
            if (prune) site.keepOnly(ids);
            site.finish();
        } catch (IOException e) {
            throw new CommandFailure(out, e);
        }
        return published;
    }

    /** Whether there is nothing to encode. */
    static boolean isArchive(EncodeJob job) {
        return job.input().toString().toLowerCase(Locale.ROOT).endsWith(".jsm");
    }

    private static EncodeResult take(EncodeJob job) {
        try {
            ArchiveFile file = ArchiveInput.readWhole(job.input());
            Path folder = job.output().getParent();
            if (folder != null) Files.createDirectories(folder);
            Files.copy(job.input(), job.output());
            return EncodeResult.of(job, file.header(), 0, List.of());
        } catch (CommandFailure e) {
            return EncodeResult.failed(job, 0, e.getMessage());
        } catch (IOException e) {
            return EncodeResult.failed(job, 0, Explanation.of(job.input(), e).toString());
        }
    }

    private EncodeResult publish(String id, EncodeJob job, EncodeResult result) {
        if (result.isFailed())
            return result.withOutput(
                    ObjectStores.isRemote(out)
                            ? out + "/m/" + id
                            : Path.of(out, "m", id).toString());
        try {
            return result.withOutput(site.publish(id, job));
        } catch (IOException e) {
            return result.failed(Explanation.of(job.input(), e).toString());
        }
    }

    @Override
    public void close() throws CommandFailure {
        try {
            site.close();
        } catch (IOException e) {
            throw new CommandFailure(out, e);
        }
    }
}
