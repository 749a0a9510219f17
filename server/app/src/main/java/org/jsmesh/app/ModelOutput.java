package org.jsmesh.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.jsmesh.app.console.CommandFailure;
import org.jsmesh.app.console.Output;
import org.jsmesh.archive.ImageInfo;
import org.jsmesh.archive.OriginalWords;
import org.jsmesh.archive.Provenance;
import org.jsmesh.files.ModelExport;
import org.jsmesh.files.OutputFiles;
import org.jsmesh.files.WrittenModel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.UpAxis;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The model file that a command writes. A mixin. */
final class ModelOutput {
    @Spec(Spec.Target.MIXEE)
    private CommandSpec spec;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "OUT",
            description = "The model file to write; its extension chooses the format: ply, obj, stl, off, m or glb.")
    private Path out;

    private ModelExport export;

    /**
     * Checks the output; call it before the work begins.
     *
     * @param input a file that must stay as it is, or null
     * @throws ParameterException when the name has no known extension, or is the input's
     * @throws CommandFailure when something other than a file is there
     */
    void check(Path input) throws CommandFailure {
        try {
            export = ModelExport.to(out);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), "-o " + out + e.getMessage(), e);
        }
        if (input != null && OutputFiles.areSame(input, out))
            throw new ParameterException(
                    spec.commandLine(), "-o " + out + " is the input itself, which would be lost: choose another name");
        try {
            OutputFiles.requireReplaceable(out);
        } catch (IOException e) {
            throw new CommandFailure(out, e);
        }
    }

    /**
     * Writes the mesh and notes what other programs may not find. Returns what the file does not hold, a sentence each.
     */
    List<String> write(Mesh mesh, UpAxis up, Output output) throws CommandFailure {
        WrittenModel written;
        try {
            written = export.write(mesh, up);
        } catch (IOException e) {
            throw new CommandFailure(out, e);
        }
        for (String remark : written.remarks()) output.note(out + ": " + remark);
        return written.losses();
    }

    /**
     * Words for an original that was written with these losses, and notes what its archive does not have of the file.
     */
    String original(List<String> losses, Provenance from, Output output) {
        String notKept = OriginalWords.notKept(from);
        if (!notKept.isEmpty()) output.note(out + ": " + notKept);
        return ModelExport.claim(losses, from);
    }

    /** Notes the images that the file refers to and that have not come yet. */
    void noteMissing(Mesh mesh, List<ImageInfo> images, Output output) {
        String missing = export.missing(mesh, images);
        if (!missing.isEmpty()) output.note(out + ": " + missing);
    }

    @Override
    public String toString() {
        return out.toString();
    }
}
