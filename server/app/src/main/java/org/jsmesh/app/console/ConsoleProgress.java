package org.jsmesh.app.console;

import java.io.Console;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;
import org.jsmesh.mesh.ProgressListener;

/** A progress bar with the time left, on a terminal; nothing where output goes to a pipe or file. */
public final class ConsoleProgress implements ProgressListener, AutoCloseable {
    private static final int STEPS = 1000;

    private final ProgressBar bar;
    private String stage = "";
    private double reached;

    private ConsoleProgress(ProgressBar bar) {
        this.bar = bar;
    }

    public static ConsoleProgress start(String task, boolean quiet) {
        if (quiet || !isTerminal()) return new ConsoleProgress(null);
        return new ConsoleProgress(new ProgressBarBuilder()
                .setTaskName(task)
                .setInitialMax(STEPS)
                .setStyle(ProgressBarStyle.ASCII)
                .setUpdateIntervalMillis(200)
                .clearDisplayOnFinish()
                .build());
    }

    /**
     * A new stage starts a new bar with its own time left, because the relative lengths of stages differ from model to
     * model. When a stage only interrupts another, the other then goes on where it stopped.
     */
    @Override
    public void progress(String newStage, double fraction) {
        if (bar == null) return;
        if (!newStage.equals(stage)) {
            stage = newStage;
            if (fraction < reached) bar.reset();
            bar.setExtraMessage(" " + newStage);
        }
        reached = fraction;
        bar.stepTo(Math.round(fraction * STEPS));
    }

    @Override
    public void close() {
        if (bar != null) bar.close();
    }

    private static boolean isTerminal() {
        Console console = System.console();
        if (console == null) return false;
        try {
            // Since Java 22 there may be a console without a terminal.
            return (Boolean) Console.class.getMethod("isTerminal").invoke(console);
        } catch (NoSuchMethodException e) {
            return true;
        } catch (ReflectiveOperationException e) {
            return false;
        }
    }
}
