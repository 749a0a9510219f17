package org.jsmesh.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import org.jsmesh.app.console.CommandFailure;
import org.jsmesh.app.console.ConsoleProgress;
import org.jsmesh.app.console.Output;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.OriginalWords;
import org.jsmesh.archive.PlainText;
import org.jsmesh.archive.Provenance;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshComparison;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.Texture;
import org.jsmesh.mesh.io.ModelFile;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code jsm verify}: is the archive's mesh the original? */
@Command(
        name = "verify",
        description = {
            "Decodes an archive and compares it with the original model file, bit for bit.",
            "Exit code 0 when they are the same multiset of oriented triangles with equal attributes, materials and images; 1 with the differences otherwise.",
            "Names what of the file the archive does not have: groups, animations, missing pictures and the like."
        },
        footer = {"", "Example: jsm verify bunny.jsm bunny.ply"})
final class VerifyCommand implements Callable<Integer> {
    @Parameters(index = "0", paramLabel = "IN.jsm", description = "The archive.")
    private Path in;

    @Parameters(index = "1", paramLabel = "ORIGINAL", description = "The model file that it was encoded from.")
    private Path original;

    @Mixin
    private Output output;

    @Override
    public Integer call() throws CommandFailure {
        ArchiveFile archive = ArchiveInput.readWhole(in);
        Mesh decoded;
        ModelFile expected;
        try (ConsoleProgress progress = output.progress(in)) {
            decoded = archive.original(progress);
        } catch (IOException e) {
            throw new CommandFailure(in, e);
        }
        try {
            expected = ModelFiles.read(original);
        } catch (IOException e) {
            throw new CommandFailure(original, e);
        }
        List<String> differences = new ArrayList<>();
        MeshComparison.firstDifference(expected.mesh(), decoded).ifPresent(differences::add);
        differences.addAll(pictureDifferences(expected.mesh(), decoded));
        if (!differences.isEmpty()) {
            throw new CommandFailure(in + " is not " + original + ": " + String.join("; ", differences)
                    + ". Encode the model again if it was changed.");
        }
        for (Texture image : decoded.textures()) {
            if (find(expected.mesh(), image.path()).isEmpty())
                output.note(
                        original + ": there is no image " + PlainText.of(image.path()) + " beside it to compare with");
        }
        print(losses(archive.header().provenance(), expected), decoded, archive.header());
        return 0;
    }

    private void print(Provenance from, Mesh decoded, ArchiveHeader header) {
        output.line((OriginalWords.hasWarning(from) ? "warning: " : "") + OriginalWords.claim(from));
        String notKept = OriginalWords.notKept(from);
        if (!notKept.isEmpty()) output.line(notKept);
        output.line("what was read of the file is in the archive, bit for bit: " + decoded.faces()
                + " faces, mesh SHA-256 " + header.meshSha256() + ", model SHA-256 " + header.modelSha256());
    }

    /** What the archive says that it has not of its file, and what reading this file says. */
    private static Provenance losses(Provenance archived, ModelFile file) {
        Set<Note> notes = new LinkedHashSet<>(archived.notes());
        notes.addAll(new Provenance("", file.notes()).bounded().notes());
        return new Provenance(archived.format(), List.copyOf(notes));
    }

    private static List<String> pictureDifferences(Mesh expected, Mesh decoded) {
        List<String> differences = new ArrayList<>();
        for (Texture texture : expected.textures()) {
            String name = PlainText.of(texture.path());
            Optional<Texture> same = find(decoded, texture.path());
            if (same.isEmpty()) {
                differences.add("the archive has no picture " + name);
                continue;
            }
            int at = Arrays.mismatch(texture.bytes(), same.get().bytes());
            if (at >= 0) differences.add("the picture " + name + " differs at byte " + at);
        }
        return differences;
    }

    private static Optional<Texture> find(Mesh mesh, String path) {
        return mesh.textures().stream().filter(t -> t.path().equals(path)).findFirst();
    }
}
