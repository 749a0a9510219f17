package org.jsmesh.app;

import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import org.jsmesh.app.console.ConsoleProgress;
import org.jsmesh.app.console.Output;
import org.jsmesh.files.EncodeJob;
import org.jsmesh.files.EncodeResult;
import org.jsmesh.files.FolderEncodeListener;

/**
 * Shows one file's stages, or the share of all files that is done. Ctrl-C cancels and leaves no half archive behind.
 */
final class EncodeProgress implements FolderEncodeListener, AutoCloseable {
    private final ConsoleProgress progress;
    private final int jobs;
    private final AtomicBoolean cancelled = new AtomicBoolean();
    private final AtomicBoolean over = new AtomicBoolean();
    private final Thread hook = new Thread(this::cancel);
    private final Output output;
    private int done;

    EncodeProgress(List<EncodeJob> jobs, Output output) {
        this.jobs = jobs.size();
        this.output = output;
        progress = this.jobs == 1 ? output.progress(jobs.get(0).input()) : output.progress(this.jobs + " files");
        Runtime.getRuntime().addShutdownHook(hook);
    }

    @Override
    public void progress(EncodeJob job, String stage, double fraction) {
        if (jobs == 1) progress.progress(stage, fraction);
    }

    @Override
    public void warned(EncodeJob job, String warning) {
        output.note(job.input() + ": warning: " + warning);
    }

    @Override
    public void finished(EncodeJob job, EncodeResult result) {
        done++;
        if (jobs > 1) progress.progress("encode", (double) done / jobs);
    }

    @Override
    public boolean isCancelled() {
        return cancelled.get();
    }

    /** Runs when the process is told to end: gives the encoder two seconds to stop and clean up. */
    private void cancel() {
        cancelled.set(true);
        try {
            for (int i = 0; i < 100 && !over.get(); i++) Thread.sleep(20);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public void close() {
        over.set(true);
        progress.close();
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException e) {
            // The process is ending; the hook was made for this.
        }
    }
}
