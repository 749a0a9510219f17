package org.jsmesh.app.paper;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.app.paper.Downloads.Part;
import org.jsmesh.files.ArchiveFile;

/**
 * The bunny as it is served: its archive, its text and, where it was brought down from more faces, the archive of all
 * of them.
 *
 * @param bunny of the paper's size
 * @param archive of it
 * @param sha256 of the archive
 * @param patches lines of its text
 * @param wholeSha256 of the archive of what the bunny was brought down from, or of the bunny's
 */
record Served(StandIn bunny, Encoded archive, String sha256, int patches, String wholeSha256) {
    private static final String NAME = "bunny";
    private static final String WHOLE = "bunny-whole";

    /** Puts all files into the folders that the servers serve. */
    static Served in(Path folder, StandIn bunny) throws IOException {
        Path archives = Files.createDirectories(folder.resolve(PaperServer.ARCHIVES));
        Path text = Files.createDirectories(folder.resolve(PaperServer.TEXT));
        Encoded archive = Encoded.of(bunny.mesh());
        Encoded whole = bunny.isReduced() ? Encoded.of(bunny.whole()) : archive;
        Files.write(archives.resolve(NAME + ".jsm"), archive.bytes());
        if (bunny.isReduced()) Files.write(archives.resolve(WHOLE + ".jsm"), whole.bytes());
        PaperFormat.Streaming streaming = PaperFormat.of(bunny.mesh(), Levels.to(bunny));
        Files.write(text.resolve("original.gz"), PaperText.compressed(PaperFormat.original(bunny.mesh())));
        Files.write(text.resolve("base.gz"), PaperText.compressed(streaming.base()));
        Files.write(text.resolve("patches.gz"), PaperText.compressed(streaming.allPatches()));
        List<String> patches = streaming.patches();
        for (int i = 0; i < patches.size(); i++)
            Files.write(text.resolve("patch-" + i + ".gz"), PaperText.compressed(patches.get(i)));
        return new Served(bunny, archive, sha256(archive), patches.size(), sha256(whole));
    }

    private static String sha256(Encoded archive) throws IOException {
        return ArchiveFile.of(archive.bytes()).sha256();
    }

    URI archive(Wire wire) {
        return wire.archives().resolve("m/" + NAME + "/" + sha256 + ".jsm");
    }

    URI wholeArchive(Wire wire) {
        return bunny.isReduced() ? wire.archives().resolve("m/" + WHOLE + "/" + wholeSha256 + ".jsm") : archive(wire);
    }

    /** The page of the whole bunny. */
    URI wholePage(Wire wire) {
        return wire.archives().resolve("m/" + (bunny.isReduced() ? WHOLE : NAME) + "/");
    }

    static Part text(Wire wire, String name) {
        return Part.whole(wire.text().resolve(name + ".gz"));
    }

    /** A request for each patch of the text. */
    List<Part> textPatches(Wire wire) {
        List<Part> parts = new ArrayList<>();
        for (int i = 0; i < patches; i++) parts.add(text(wire, "patch-" + i));
        return parts;
    }

    /** A request for each patch of the archive: the bytes after the base in as many pieces. */
    List<Part> archivePatches(Wire wire) {
        List<Part> parts = new ArrayList<>();
        long base = archive.baseBytes();
        long rest = archive.bytes().length - base;
        // No request is for nothing.
        int count = (int) Math.min(archive.patches(), rest);
        for (int i = 0; i < count; i++)
            parts.add(Part.of(archive(wire), base + rest * i / count, base + rest * (i + 1) / count));
        return parts;
    }
}
