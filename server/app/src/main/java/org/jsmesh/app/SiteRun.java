package org.jsmesh.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.encoder.EncodeJob;
import org.jsmesh.encoder.EncodeResult;
import org.jsmesh.encoder.Explanation;
import org.jsmesh.site.StaticSite;

/** One run of {@code jsm encode --site}. */
final class SiteRun implements AutoCloseable {
    private final Path out;
    private final StaticSite site;

    private SiteRun(Path out, StaticSite site) {
        this.out = out;
        this.site = site;
    }

    static SiteRun begin(Path out) throws CommandFailure {
        try {
            return new SiteRun(out, StaticSite.open(out));
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
     * @param results of the jobs, in their order
     * @param prune whether models go that no job is for
     * @return the results with the archives' places
     */
    List<EncodeResult> publish(List<EncodeJob> jobs, List<EncodeResult> results, boolean prune) throws CommandFailure {
        List<String> ids = site.ids(jobs);
        List<EncodeResult> published = new ArrayList<>();
        for (int i = 0; i < results.size(); i++) published.add(publish(ids.get(i), jobs.get(i), results.get(i)));
        try {
            if (prune) site.keepOnly(ids);
            site.finish();
        } catch (IOException e) {
            throw new CommandFailure(out, e);
        }
        return published;
    }

    private EncodeResult publish(String id, EncodeJob job, EncodeResult result) {
        if (result.isFailed())
            return result.withOutput(out.resolve("m").resolve(id).toString());
        try {
            return result.withOutput(site.publish(id, job).toString());
        } catch (IOException e) {
            return result.failed(Explanation.of(job.input(), e));
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
