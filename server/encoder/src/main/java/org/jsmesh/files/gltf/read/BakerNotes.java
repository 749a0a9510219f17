package org.jsmesh.files.gltf.read;

import java.util.List;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.io.ModelFormatException;

/** Counts what does not become triangles. */
final class BakerNotes {
    private int others;
    private int stitches;
    private int rests;
    private int morphs;
    private boolean morphed; // do some of them shape what is shown first?

    /** Counts what a mesh has apart from triangles. */
    void add(MeshParts parts) {
        others = sum(others, parts.others());
        rests = sum(rests, parts.rests());
    }

    void addStitch() {
        stitches++;
    }

    void addMorphs(int targets, boolean shown) {
        morphs = sum(morphs, targets);
        morphed |= targets > 0 && shown;
    }

    void requireTriangles(GltfDocument document) throws ModelFormatException {
        if (others > 0)
            throw document.error("it has points or lines alone, and no triangles", "Export a model with triangles");
    }

    private static int sum(int a, int b) {
        return (int) Math.min(Integer.MAX_VALUE, (long) a + b);
    }

    void report(List<Note> notes) {
        if (others > 0) {
            String text = NoteText.count(others, "primitive") + " left out: points, lines or no positions.";
            notes.add(Note.dropped(text, others, "").asWarning());
        }
        if (stitches > 0) {
            String text = NoteText.count(stitches, "degenerate triangle") + " that stitch strips dropped.";
            notes.add(Note.repaired(text, stitches, ""));
        }
        if (rests > 0) {
            String text = NoteText.count(rests, "primitive")
                    + " whose number of corners is no multiple of three: the rest left out.";
            notes.add(Note.dropped(text, rests, ""));
        }
        if (morphs > 0) {
            Note note = Note.dropped("Morph targets dropped.", morphs, "");
            notes.add(morphed ? note.asWarning() : note);
        }
    }
}
