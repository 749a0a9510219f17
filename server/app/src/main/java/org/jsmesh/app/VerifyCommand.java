package org.jsmesh.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshComparison;
import org.jsmesh.mesh.Texture;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code jsm verify}: is the archive's mesh the original? */
@Command(
        name = "verify",
        description = {
            "Decodes an archive and compares it with the original model file, bit for bit.",
            "Exit code 0 when they are the same multiset of oriented triangles with equal attributes, materials and images; 1 with the first difference otherwise."
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
        Mesh expected;
        try (ConsoleProgress progress = output.progress(in)) {
            decoded = archive.original(progress);
        } catch (IOException e) {
            throw new CommandFailure(in, e);
        }
        try {
            expected = ModelFiles.read(original).mesh();
        } catch (IOException e) {
            throw new CommandFailure(original, e);
        }
        Optional<String> difference =
                MeshComparison.firstDifference(expected, decoded).or(() -> imageDifference(expected, decoded));
        if (difference.isPresent()) {
            throw new CommandFailure(in + " is not " + original + ": " + difference.get()
                    + ". Encode the model again if it was changed.");
        }
        for (Texture image : decoded.textures()) {
            if (expected.textures().stream().noneMatch(t -> t.path().equals(image.path())))
                output.note(original + ": there is no image " + image.path() + " beside it to compare with");
        }
        output.line("identical: " + decoded.faces() + " faces, SHA-256 "
                + archive.header().meshSha256());
        return 0;
    }

    private static Optional<String> imageDifference(Mesh expected, Mesh decoded) {
        for (Texture texture : expected.textures()) {
            Optional<Texture> same = decoded.textures().stream()
                    .filter(t -> t.path().equals(texture.path()))
                    .findFirst();
            if (same.isEmpty()) return Optional.of("image " + texture.path() + " is missing");
            int at = Arrays.mismatch(texture.bytes(), same.get().bytes());
            if (at >= 0) return Optional.of("image " + texture.path() + " differs at byte " + at);
        }
        return Optional.empty();
    }
}
