package org.jsmesh.desktop.panel;

import java.util.List;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.mesh.Note;
import org.jsmesh.session.ArrivedBytes;
import org.jsmesh.session.SessionProgress;
import org.jsmesh.session.SessionResult;

/**
 * What is known of a model that is shown. Immutable, but for the bytes, which go on arriving.
 *
 * @param header what the archive says of itself, or null until it has come
 * @param progress how far loading is, or null at first
 * @param rounds that have ended
 * @param result the proof, or null until everything has come
 * @param arrived the bytes of the archive
 * @param repairs what of a model file was mended or lost when it was encoded here
 */
public record ModelFacts(
        ArchiveHeader header,
        SessionProgress progress,
        int rounds,
        SessionResult result,
        ArrivedBytes arrived,
        List<Note> repairs) {
    /** Nothing is known, or no model is there. */
    public static final ModelFacts NONE = new ModelFacts(null, null, 0, null, new ArrivedBytes(), List.of());

    /** {@return the number of batches of which a resolution can be shown} */
    public int batches() {
        return header == null || progress == null ? 0 : progress.batches();
    }

    /** {@return whether there is something to be seen} */
    public boolean isShown() {
        return batches() > 0;
    }

    /** {@return what of the model file was lost or mended: as the archive tells, or as its encoding here did} */
    public List<Note> notes() {
        if (!repairs.isEmpty()) return repairs;
        return header == null ? List.of() : header.provenance().notes();
    }
}
