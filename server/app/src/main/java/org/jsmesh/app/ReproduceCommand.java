package org.jsmesh.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Callable;
import org.jsmesh.app.console.CommandFailure;
import org.jsmesh.app.console.ConsoleProgress;
import org.jsmesh.app.console.Output;
import org.jsmesh.app.paper.Reproduction;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code jsm reproduce}: the experiments of the paper. */
@Command(
        name = "reproduce",
        description = {
            "Runs the experiments of Chen and Nishita 2002 on this machine: tables 1 to 5, figures 8 to 10.",
            "Writes a page of Markdown for each, with the paper's figures beside those measured, and CSV or PNG. Takes some eleven minutes, most of them waiting at 64 kbit/s."
        },
        footer = {
            "",
            "Examples:",
            "  jsm reproduce --models models -o results",
            "  jsm reproduce --only table1,table2 -o results"
        })
final class ReproduceCommand implements Callable<Integer> {
    private static final Path USUAL_MODELS = Path.of("models");

    @Spec
    private CommandSpec spec;

    @Option(
            names = "--models",
            paramLabel = "DIR",
            description = {
                "Where bunny, dragon, hand, cessna and fandisk are, or models to stand for them; larger ones are brought down to the paper's number of faces.",
                "Default: the folder models here. What is not found is generated."
            })
    private Path models;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "OUT",
            description = "The folder to write to.")
    private Path out;

    @Option(
            names = "--only",
            paramLabel = "PART",
            split = ",",
            description = "Run these alone: table1 to table5, figure8 to figure10. Several with commas between.")
    private List<String> only = Reproduction.PARTS;

    @Option(
            names = "--tc",
            description =
                    "Let the kernel shape the links, by a network namespace and tc. Needs Linux, root and iproute2. Default: a proxy in this process does.")
    private boolean kernel;

    @Mixin
    private Output output;

    @Override
    public Integer call() throws CommandFailure {
        Set<String> parts = new LinkedHashSet<>(only);
        for (String part : parts)
            if (!Reproduction.PARTS.contains(part))
                throw new ParameterException(
                        spec.commandLine(),
                        "--only is " + part + ", it must be some of " + String.join(", ", Reproduction.PARTS));
        if (models != null && !Files.isDirectory(models))
            throw new CommandFailure(models + ": no such folder. Give --models the folder that the models are in, or"
                    + " leave it out for generated ones.");
        Path folder = models != null ? models : Files.isDirectory(USUAL_MODELS) ? USUAL_MODELS : null;
        try (ConsoleProgress progress = output.progress("reproduce")) {
            new Reproduction(folder, out, kernel, file -> output.line(file.toString()), progress).run(parts);
        } catch (IOException e) {
            throw new CommandFailure(null, e);
        }
        return 0;
    }
}
