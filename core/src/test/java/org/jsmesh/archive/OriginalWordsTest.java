package org.jsmesh.archive;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Collections;
import java.util.List;
import org.jsmesh.mesh.Note;
import org.junit.jupiter.api.Test;

class OriginalWordsTest {
    private static final Note GROUPS = Note.dropped("3 group and object names not kept.", 3, "line 7");
    private static final Note ANIMATIONS = Note.dropped("Animations dropped.", 1, "animation 0");
    private static final Note INSTANCES =
            Note.dropped("124 instances of meshes missing.", 124, "").asWarning();

    private static Provenance of(Note... notes) {
        return new Provenance("OBJ", List.of(notes));
    }

    @Test
    void shouldCallIdenticalWhatLostNothing() {
        assertThat(OriginalWords.claim(of()))
                .isEqualTo("identical to the original file's geometry, materials and pictures");
        assertThat(OriginalWords.warning(of())).isEmpty();
        assertThat(OriginalWords.notKept(of())).isEmpty();
        assertThat(OriginalWords.claim(Provenance.NONE)).startsWith("identical");
    }

    @Test
    void shouldNameWhatWasNotKeptBesideTheClaim() {
        assertThat(OriginalWords.claim(of(GROUPS, ANIMATIONS))).startsWith("identical");
        assertThat(OriginalWords.notKept(of(GROUPS, ANIMATIONS)))
                .isEqualTo("of the file not kept: 3 group and object names; animations");
    }

    @Test
    void shouldNeverCallIdenticalWhatLostSomethingSeen() {
        assertThat(OriginalWords.claim(of(GROUPS, INSTANCES)))
                .isEqualTo("not the whole original: 124 instances of meshes missing")
                .isEqualTo(OriginalWords.warning(of(INSTANCES)));
        assertThat(OriginalWords.notKept(of(GROUPS, INSTANCES)))
                .isEqualTo("of the file not kept: 3 group and object names");
    }

    @Test
    void shouldNotTellWhatWasMended() {
        assertThat(OriginalWords.notKept(of(Note.repaired("2 vertices merged.", 2, ""))))
                .isEmpty();
    }

    @Test
    void shouldCountWhatIsTooMuchToTell() {
        Provenance many = new Provenance("", Collections.nCopies(10, GROUPS));
        assertThat(OriginalWords.notKept(many)).endsWith("names; and 2 more");
    }
}
