package org.jsmesh.archive.coding;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.PlainText;
import org.jsmesh.archive.Provenance;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.IntegerModel;
import org.jsmesh.codec.entropy.TextModel;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.Note.Kind;

/**
 * Codes the notes of a header in both directions. There are at most {@link Provenance#MOST_NOTES}, of texts that are
 * fit to be shown, whoever wrote the archive.
 */
final class NoteCoder {
    private static final int KIND_BITS = 2;

    private final boolean write;
    private final IntegerModel counts = new IntegerModel(1);
    private final TextModel texts = new TextModel();

    NoteCoder(boolean write) {
        this.write = write;
    }

    /** Codes as many notes as {@link Provenance#bounded} leaves. */
    List<Note> code(BinaryCoder coder, List<Note> list) throws MalformedStreamException {
        int n = counts.unsigned(coder, write ? list.size() : 0);
        if (n < 0 || n > Provenance.MOST_NOTES) throw new MalformedStreamException(-1, "a header with " + n + " notes");
        List<Note> notes = new ArrayList<>();
        for (int i = 0; i < n; i++) {
            if (coder.isExhausted()) throw new MalformedStreamException(-1, "the header ends early");
            notes.add(code(coder, write ? list.get(i) : null));
        }
        return notes;
    }

    private Note code(BinaryCoder coder, Note note) throws MalformedStreamException {
        Kind kind = Kind.values()[coder.raw(write ? note.kind().ordinal() : 0, KIND_BITS)];
        boolean warning = coder.raw(write && note.warning() ? 1 : 0, 1) == 1;
        int count = counts.unsigned(coder, write ? note.count() : 0);
        if (count < 1) throw new MalformedStreamException(-1, "a note that counts " + count);
        String text = text(coder, write ? note.text() : null, Provenance.MOST_TEXT);
        return new Note(
                kind, text, count, text(coder, write ? note.example() : null, Provenance.MOST_EXAMPLE), warning);
    }

    private String text(BinaryCoder coder, String text, int most) throws MalformedStreamException {
        return PlainText.fit(texts.code(coder, text), most);
    }
}
