package org.jsmesh.archive.coding;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.Provenance;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.IntegerModel;
import org.jsmesh.codec.entropy.RangeDecoder;
import org.jsmesh.codec.entropy.RangeEncoder;
import org.jsmesh.codec.entropy.TextModel;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Note;
import org.junit.jupiter.api.Test;

class NoteCoderTest {
    @Test
    void shouldGiveNotesBackAsTheyWere() throws Exception {
        List<Note> notes = List.of(
                Note.dropped("3 group names not kept.", 3, "Räder 车轮 \ud83d\ude97"),
                Note.changed("24 positions rounded.", 24, "vertex 0").asWarning(),
                Note.unread("Elements skipped: edge.", Integer.MAX_VALUE, ""));
        assertThat(coded(bounded(notes))).isEqualTo(notes);
    }

    @Test
    void shouldLeaveOutNotesOfWhatWasMended() throws Exception {
        Note lost = Note.dropped("Animations dropped.", 1, "animation 0");
        assertThat(coded(bounded(List.of(Note.repaired("2 vertices merged.", 2, ""), lost))))
                .containsExactly(lost);
    }

    @Test
    void shouldCountTheNotesThatHaveNoRoom() throws Exception {
        List<Note> notes = new ArrayList<>();
        for (int i = 0; i < 70; i++) notes.add(Note.dropped("loss " + i, 1, ""));
        List<Note> kept = coded(bounded(notes));
        assertThat(kept).hasSize(64).startsWith(notes.subList(0, 63).toArray(Note[]::new));
        assertThat(kept.get(63)).isEqualTo(Note.dropped("7 more notes left out.", 7, ""));

        notes.set(69, notes.get(69).asWarning());
        assertThat(coded(bounded(notes)).get(63).warning()).isTrue();
    }

    @Test
    void shouldKeepExactlyAsManyNotesAsThereIsRoomFor() throws Exception {
        List<Note> notes = new ArrayList<>();
        for (int i = 0; i < 64; i++) notes.add(Note.dropped("loss " + i, 1, ""));
        assertThat(coded(bounded(notes))).isEqualTo(notes);
    }

    @Test
    void shouldShortenLongTexts() throws Exception {
        Note note = coded(bounded(List.of(Note.dropped("é".repeat(5000), 1, "x".repeat(101)))))
                .get(0);
        assertThat(note.text()).isEqualTo("é".repeat(299) + "…");
        assertThat(note.example()).isEqualTo("x".repeat(99) + "…");
    }

    @Test
    void shouldReplaceControlCharactersThatAStrangerWrote() throws Exception {
        byte[] stream = written(1, 1, 1, "red \u001b[31m\n\u202etxt\u0000", "\r\u0085");
        Note note = decoded(stream).get(0);
        assertThat(note.text()).isEqualTo("red \ufffd[31m\ufffd\ufffdtxt\ufffd");
        assertThat(note.example()).isEqualTo("\ufffd\ufffd");
    }

    @Test
    void shouldRefuseMoreNotesThanThereMayBe() throws Exception {
        byte[] stream = written(65, 1, 1, "", "");
        assertThatThrownBy(() -> decoded(stream))
                .isInstanceOf(MalformedStreamException.class)
                .hasMessageContaining("65 notes");
    }

    @Test
    void shouldRefuseANoteThatCountsNothing() throws Exception {
        byte[] stream = written(1, 1, 0, "", "");
        assertThatThrownBy(() -> decoded(stream))
                .isInstanceOf(MalformedStreamException.class)
                .hasMessageContaining("counts 0");
    }

    @Test
    void shouldRefuseNotesThatEndEarly() throws Exception {
        byte[] stream = written(64, 1, 1, "text", "");
        assertThatThrownBy(() -> decoded(stream)).isInstanceOf(MalformedStreamException.class);
    }

    private static List<Note> coded(List<Note> notes) throws MalformedStreamException {
        RangeEncoder out = new RangeEncoder();
        new NoteCoder(true).code(out, notes);
        return decoded(out.finish());
    }

    /** What an archive holds of the notes. */
    private static List<Note> bounded(List<Note> notes) {
        return new Provenance("PLY", notes).bounded().notes();
    }

    private static List<Note> decoded(byte[] stream) throws MalformedStreamException {
        return new NoteCoder(false).code(new RangeDecoder(stream, 0, stream.length), null);
    }

    /** The stream of one note as anybody may write it. */
    private static byte[] written(int notes, int kind, int count, String text, String example) throws Exception {
        RangeEncoder out = new RangeEncoder();
        BinaryCoder coder = out;
        IntegerModel counts = new IntegerModel(1);
        TextModel texts = new TextModel();
        counts.unsigned(coder, notes);
        coder.raw(kind, 2);
        coder.raw(0, 1);
        counts.unsigned(coder, count);
        texts.code(coder, text);
        texts.code(coder, example);
        return out.finish();
    }
}
