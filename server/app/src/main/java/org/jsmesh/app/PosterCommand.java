package org.jsmesh.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.jsmesh.app.console.CommandFailure;
import org.jsmesh.app.console.Output;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.files.AtomicFiles;
import org.jsmesh.files.OutputFiles;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code jsm poster}: the picture that an archive has of its model. */
@Command(
        name = "poster",
        description = "Writes the poster of an archive: a small picture of the model, as a JPEG file.",
        footer = {"", "Example: jsm poster bunny.jsm -o bunny.jpg"})
final class PosterCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "IN.jsm", description = "The archive.")
    private Path in;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "OUT",
            description = "The JPEG file to write.")
    private Path out;

    @Mixin
    private Output output;

    @Override
    public Integer call() throws CommandFailure {
        if (OutputFiles.areSame(in, out))
            throw new ParameterException(
                    spec.commandLine(), "-o " + out + " is the input itself, which would be lost: choose another name");
        byte[] poster = poster(ArchiveInput.readWhole(in));
        try {
            OutputFiles.requireReplaceable(out);
            AtomicFiles.write(out, poster);
        } catch (IOException e) {
            throw new CommandFailure(out, e);
        }
        output.line(out + ": " + poster.length + " bytes");
        return 0;
    }

    private byte[] poster(ArchiveFile archive) throws CommandFailure {
        byte[] poster;
        try {
            poster = archive.poster();
        } catch (IOException e) {
            throw new CommandFailure(in, e);
        }
        if (poster == null)
            throw new CommandFailure(in + ": the archive has no poster. Encode the model again without --no-poster.");
        return poster;
    }
}
