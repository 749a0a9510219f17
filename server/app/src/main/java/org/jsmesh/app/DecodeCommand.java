package org.jsmesh.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.jsmesh.app.console.CommandFailure;
import org.jsmesh.app.console.ConsoleProgress;
import org.jsmesh.app.console.Output;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.mesh.Mesh;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

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
    @Parameters(paramLabel = "IN.jsm", description = "The archive, or the first part of one.")
    private Path in;

    @Mixin
    private ModelOutput out;

    @ArgGroup(heading = "%nOne of these chooses a coarser resolution:%n")
    private Lod lod;

    @Mixin
    private Output output;

    @Override
    public Integer call() throws CommandFailure {
        out.check(in);
        ArchiveFile archive = ArchiveInput.read(in);
        BatchIndex index = archive.index();
        if (lod == null && !archive.isWhole()) throw new CommandFailure(ArchiveInput.cut(in, archive));
        int batch = lod == null ? index.size() - 1 : lod.batch(in, archive);
        Mesh mesh;
        try (ConsoleProgress progress = output.progress(in)) {
            mesh = lod == null ? archive.original(progress) : archive.meshAfter(batch, progress);
        } catch (IOException e) {
            throw new CommandFailure(in, e);
        }
        List<String> losses = out.write(mesh, archive.opening().up(), output);
        if (lod != null) {
            for (String loss : losses) output.note(out + ": " + loss);
            out.noteMissing(mesh, archive.opening().images(), output);
        }
        String what = lod == null
                ? out.original(losses, archive.header().provenance(), output)
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
