package org.jsmesh.desktop.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.desktop.draw.Shapes;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.session.ArrivedBytes;
import org.jsmesh.session.SessionProgress;
import org.jsmesh.session.SessionResult;
import org.junit.jupiter.api.Test;

class StatisticsTest {
    private static final Mesh MESH = Shapes.paintedTorus(60, 20);
    private static final EncodedArchive ARCHIVE =
            new MeshEncoder(EncoderSettings.defaults()).encode(MESH, ProgressListener.NONE);
    private static final int BATCHES = ARCHIVE.header().batches().size();
    private static final SessionProgress END =
            new SessionProgress(ARCHIVE.bytes().length, ARCHIVE.bytes().length, BATCHES, BATCHES, 2400, 2400, 1, 0, 0);

    private static ModelFacts facts(SessionProgress progress, SessionResult result, Note... repairs) {
        return new ModelFacts(ARCHIVE.header(), progress, 2, result, new ArrivedBytes(), List.of(repairs));
    }

    @Test
    void shouldTellOfModelAndLoading() {
        List<Statistics.Row> rows = Statistics.rows(facts(END, null), BATCHES - 1, 700, 1_000_000, 8_000_000);
        assertThat(rows)
                .contains(
                        new Statistics.Row("Faces", "2,400 of 2,400"),
                        new Statistics.Row("Vertices", "1,200 of 1,200"),
                        new Statistics.Row("Batches", BATCHES + " of " + BATCHES),
                        new Statistics.Row("Rounds", "2"),
                        new Statistics.Row("Closed", "yes"),
                        new Statistics.Row("Memory", "1.0 MB of 8.0 MB"));
        assertThat(rows)
                .extracting(Statistics.Row::name)
                .contains("Materials", "Bits per face")
                .doesNotContain("Up");
    }

    @Test
    void shouldTellWhetherTheResolutionLooksLikeTheOriginal() {
        double within = ARCHIVE.header().batches().errorQuantile(0);
        assertThat(within).isPositive();
        double pixels = 100 / within; // 1 of them is the error
        assertThat(Statistics.rows(facts(END, null), 0, pixels, 1, 2))
                .contains(
                        new Statistics.Row("99.9% within", Figures.percent(within)),
                        new Statistics.Row("At this size", "off by 1.0 pixels"));
        assertThat(Statistics.rows(facts(END, null), 0, 12 * pixels, 1, 2))
                .contains(new Statistics.Row("At this size", "off by 12 pixels"));
        assertThat(Statistics.rows(facts(END, null), 0, .49 * pixels, 1, 2))
                .contains(new Statistics.Row("At this size", "as good as the original"));
        assertThat(Statistics.rows(facts(END, null), 0, Double.NaN, 1, 2))
                .extracting(Statistics.Row::name)
                .contains("99.9% within")
                .doesNotContain("At this size");
    }

    @Test
    void shouldTellOfMemoryAloneWithoutAModel() {
        assertThat(Statistics.rows(ModelFacts.NONE, -1, Double.NaN, 1, 2))
                .extracting(Statistics.Row::name)
                .containsExactly("Memory");
        assertThat(Statistics.proof(ModelFacts.NONE)).isEmpty();
        assertThat(Statistics.notes(ModelFacts.NONE)).isEmpty();
    }

    @Test
    void shouldGiveTheHashesOfWhatWasProven() {
        String hash = ARCHIVE.header().meshSha256();
        assertThat(Statistics.proof(facts(END, new SessionResult(MESH, hash, "ab", null))))
                .startsWith("Proven: identical")
                .contains(hash, ARCHIVE.header().modelSha256(), "archive: ab.");
        assertThat(Statistics.proof(facts(END, new SessionResult(MESH, hash, "ab", "a picture was altered"))))
                .isEqualTo("Not the original: a picture was altered.");
    }

    @Test
    void shouldListNotesWithTheirPlaces() {
        Note repaired = Note.repaired("3 faces without area removed.", 3, "face 7");
        Note lost = Note.dropped("1 part missing.", 1, "").asWarning();
        assertThat(Statistics.notes(facts(END, null, repaired, lost)))
                .isEqualTo("3 faces without area removed. First: face 7.\n⚠ 1 part missing.");
    }

    @Test
    void shouldStepThroughWhatHasArrivedAndFollowTheNewest() {
        List<Integer> chosen = new ArrayList<>();
        DetailSlider slider = new DetailSlider(chosen::add);
        slider.step(false);
        assertThat(chosen).isEmpty();
        slider.show(facts(END, null));
        assertThat(slider.isNewest()).isTrue();
        slider.step(false);
        assertThat(slider.isNewest()).isFalse();
        int coarser = chosen.get(0);
        assertThat(ARCHIVE.header().batches().faces(coarser)).isLessThan(2400);
        for (int i = 0; i < BATCHES; i++) slider.step(false);
        assertThat(chosen.get(chosen.size() - 1)).isZero();
        for (int i = 0; i < 2 * BATCHES; i++) slider.step(true);
        assertThat(chosen.get(chosen.size() - 1)).isEqualTo(DetailSlider.NEWEST);
        assertThat(slider.isNewest()).isTrue();
    }

    @Test
    void shouldForgetTheChoiceWhenAnotherModelComes() {
        DetailSlider slider = new DetailSlider(batch -> {});
        slider.show(facts(END, null));
        slider.step(false);
        slider.show(ModelFacts.NONE);
        assertThat(slider.isNewest()).isTrue();
    }
}
