package org.jsmesh.encode;

import java.util.List;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.mesh.Note;

/**
 * An encoded mesh.
 *
 * @param bytes the whole archive file
 * @param header what the file says of itself
 * @param notes what of the model was mended or lost, in the order in which it was found; the header has those of losses
 */
public record EncodedArchive(byte[] bytes, ArchiveHeader header, List<Note> notes) {
    /**
     * Copies the list of notes.
     *
     * @param bytes see {@link #bytes()}
     * @param header see {@link #header()}
     * @param notes see {@link #notes()}
     */
    public EncodedArchive {
        notes = List.copyOf(notes);
    }
}
