package org.jsmesh.upload;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Note;

/** The notes in an archive. The process that encodes a model gives nothing back but the archive. */
final class ArchiveNotes {
    private static final int BLOCK = 1 << 13;

    private ArchiveNotes() {}

    /** Reads the archive up to the end of its header; empty when it has none, which whoever opens it tells. */
    static List<Note> of(Path archive) throws IOException {
        ArchiveDecoder decoder = new ArchiveDecoder();
        byte[] block = new byte[BLOCK];
        try (InputStream in = Files.newInputStream(archive)) {
            for (int n; decoder.header() == null && (n = in.read(block)) >= 0; ) decoder.feed(block, 0, n);
        } catch (MalformedStreamException e) {
            return List.of();
        }
        return decoder.header() == null
                ? List.of()
                : decoder.header().provenance().notes();
    }
}
