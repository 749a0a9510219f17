package org.jsmesh.app.console;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.json.JsonWriteFeature;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.nio.file.Path;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Options of every command, and its output: figures on stdout, notes and progress on stderr. A mixin. */
public final class Output {
    /** JSON passes through any character set of the terminal. */
    public static final ObjectMapper JSON =
            JsonMapper.builder().enable(JsonWriteFeature.ESCAPE_NON_ASCII).build();

    @Spec(Spec.Target.MIXEE)
    private CommandSpec spec;

    @Option(
            names = {"-h", "--help"},
            usageHelp = true,
            description = "Show this help and exit.")
    private boolean help;

    @Option(names = "--quiet", description = "No progress, no report; only failures are printed.")
    private boolean quiet;

    /** A line of the report. */
    public void line(String text) {
        if (!quiet) spec.commandLine().getOut().println(text);
    }

    /** Something the user should know although the command goes on. */
    public void note(String text) {
        if (!quiet) spec.commandLine().getErr().println(text);
    }

    public void error(String text) {
        spec.commandLine().getErr().println(spec.qualifiedName() + ": " + text);
    }

    /** Prints the one JSON value of a command. It is never silenced, because it was asked for. */
    public void json(Object value) {
        try {
            spec.commandLine().getOut().println(JSON.writeValueAsString(value));
        } catch (JsonProcessingException e) {
            throw new IllegalStateException(e);
        }
    }

    /** A progress bar on a terminal, named for the file that is worked on; nothing elsewhere. */
    public ConsoleProgress progress(Path file) {
        // The file's name alone, because a path would leave the bar no room.
        return progress(String.valueOf(file.getFileName()));
    }

    /** A progress bar on a terminal, nothing elsewhere. */
    public ConsoleProgress progress(String task) {
        return ConsoleProgress.start(task, quiet);
    }
}
