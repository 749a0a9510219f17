package org.jsmesh.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.encoder.ArchiveFile;
import org.jsmesh.encoder.ModelFiles;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.io.ModelFormat;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code jsm decode}: an archive in, the original or a coarser resolution out. */
@Command(
        name = "decode",
        description = {
            "Decodes the original, or a coarser resolution of it, as a model file.",
            "Of a file that is cut, every whole batch can be decoded: name a resolution."
        },
        footer = {
            "",
            "Examples:",
            "  jsm decode bunny.jsm -o bunny.ply",
            "  jsm decode bunny.jsm -o small.obj --faces 2000"
        })
final class DecodeCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "IN.jsm", description = "The archive, or the first part of one.")
    private Path in;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "OUT",
            description = "The model file to write; its extension chooses the format: ply, obj, stl, off, m or glb.")
    private Path out;

    @ArgGroup(heading = "%nOne of these chooses a coarser resolution:%n")
    private Lod lod;

    @Mixin
    private Output output;

    @Override
    public Integer call() throws CommandFailure {
        ModelFormat format = ModelFormat.ofName(out.toString());
        if (format == null)
            throw new ParameterException(
                    spec.commandLine(), "-o " + out + " has no known extension (ply, obj, stl, off, m, glb)");
        ArchiveFile archive = Archives.read(in);
        BatchIndex index = archive.header().batches();
        if (lod == null && !archive.isWhole()) throw new CommandFailure(Archives.cut(in, archive));
        int batch = lod == null ? index.size() - 1 : lod.batch(in, archive);
        Mesh mesh;
        try (ConsoleProgress progress = output.progress(in)) {
            mesh = lod == null ? archive.original(progress) : archive.meshAfter(batch, progress);
        } catch (IOException e) {
            throw new CommandFailure(in, e);
        }
        try {
            for (String note : ModelFiles.write(mesh, out, format)) output.note(out + ": " + note);
        } catch (IOException e) {
            throw new CommandFailure(out, e);
        }
        String what = lod == null
                ? "the original"
                : String.format(
                        Locale.ROOT,
                        "mean error %.4f%%, batch %d of 0 to %d, first %d bytes",
                        index.errorMean(batch),
                        batch,
                        index.size() - 1,
                        index.end(batch));
        output.line(out + ": " + mesh.faces() + " faces, " + mesh.vertices() + " vertices, " + what);
        return 0;
    }
}
