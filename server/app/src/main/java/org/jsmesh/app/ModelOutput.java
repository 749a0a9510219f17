package org.jsmesh.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.jsmesh.archive.OriginalWords;
import org.jsmesh.archive.Provenance;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.files.OutputFiles;
import org.jsmesh.files.WrittenModel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Texture;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.mesh.io.ModelFormat;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The model file that a command writes. A mixin. */
final class ModelOutput {
    private static final int MOST_NAMES = 4;

    @Spec(Spec.Target.MIXEE)
    private CommandSpec spec;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "OUT",
            description = "The model file to write; its extension chooses the format: ply, obj, stl, off, m or glb.")
    private Path out;

    private ModelFormat format;

    /**
     * Checks the output; call it before the work begins.
     *
     * @param input a file that must stay as it is, or null
     * @throws ParameterException when the name has no known extension, or is the input's
     * @throws CommandFailure when something other than a file is there
     */
    void check(Path input) throws CommandFailure {
        format = ModelFormat.toWrite(out.toString());
        if (format == null) {
            String why = ModelFormat.isGltfText(out.toString())
                    ? ": glTF is written in its binary form, name it .glb"
                    : ModelFormat.ofName(out.toString()) == ModelFormat.THREE_MF
                            ? ": 3MF is read and not written, choose glb or obj"
                            : " has no known extension (ply, obj, stl, off, m, glb)";
            throw new ParameterException(spec.commandLine(), "-o " + out + why);
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
            written = ModelFiles.write(mesh, up, out, format);
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
        String claim = (OriginalWords.hasWarning(from) ? "warning: " : "") + OriginalWords.claim(from);
        if (losses.isEmpty()) return claim;
        boolean whole = !OriginalWords.hasWarning(from);
        String written = "every face of the " + (whole ? "original" : "archive") + ", but: " + String.join(" ", losses);
        return whole ? written : written + " " + claim;
    }

    /**
     * Notes the images that the file refers to and that have not come yet.
     *
     * @param images paths of all images of the archive
     */
    void noteMissing(Mesh mesh, Set<String> images, Output output) {
        if (format != ModelFormat.OBJ && format != ModelFormat.PLY && format != ModelFormat.GLB) return;
        Set<String> missing = new TreeSet<>();
        for (Material material : mesh.materials())
            for (Material.TextureReference reference : material.textures()) missing.add(reference.path());
        missing.retainAll(images);
        for (Texture texture : mesh.textures()) missing.remove(texture.path());
        if (missing.isEmpty()) return;
        String names = String.join(", ", missing.stream().limit(MOST_NAMES).toList());
        String more = missing.size() > MOST_NAMES ? " and " + (missing.size() - MOST_NAMES) + " more" : "";
        output.note(out + ": " + missing.size()
                + (missing.size() == 1 ? " image that it refers to comes" : " images that it refers to come")
                + " later in the archive and " + (missing.size() == 1 ? "is" : "are") + " not written: " + names + more
                + ". Ask for a finer resolution to get " + (missing.size() == 1 ? "it." : "them."));
    }

    @Override
    public String toString() {
        return out.toString();
    }
}
