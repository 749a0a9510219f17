package org.jsmesh.encode;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.util.List;
import org.jsmesh.mesh.UpAxis;
import org.junit.jupiter.api.Test;

class EncoderSettingsTest {
    private final EncoderSettings paper = EncoderSettings.defaults().withSimplifier(Simplifier.PAPER);

    @Test
    void shouldKeepAllElseWhenOneSettingChanges() {
        EncoderSettings all = paper.withLevels(List.of(.25, .5))
                .withBaseFaces(7)
                .withThreads(3)
                .withKeepOrder(true)
                .withQuality(Quality.BEST)
                .withUp(UpAxis.Z);
        assertThat(all)
                .isEqualTo(new EncoderSettings(
                        7, 3, true, Simplifier.PAPER, Quality.BEST, List.of(.25, .5), UpAxis.Z, true));
        assertThat(all.withSimplifier(Simplifier.QUADRIC))
                .isEqualTo(
                        new EncoderSettings(7, 3, true, Simplifier.QUADRIC, Quality.BEST, List.of(), UpAxis.Z, true));
    }

    @Test
    void shouldRefuseLevelsThatDoNotAscendFromAboveZero() {
        for (List<Double> levels : List.of(
                List.of(0.0), List.of(-1.0), List.of(.5, .25), List.of(.5, .5), List.of(Double.NaN), List.of(1e7)))
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> paper.withLevels(levels))
                    .withMessageContaining(levels.toString());
    }

    @Test
    void shouldRefuseLevelsForAnotherSimplifier() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> EncoderSettings.defaults().withLevels(List.of(.25)))
                .withMessageContaining("simplifier of the paper");
    }

    @Test
    void shouldTravelToOtherMachines() throws IOException, ClassNotFoundException {
        for (EncoderSettings settings : different()) {
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
                out.writeObject(settings);
            }
            try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
                assertThat(in.readObject()).isEqualTo(settings);
            }
        }
    }

    @Test
    void shouldHaveAKeyForAllThatTheBytesDependOn() {
        assertThat(EncoderSettings.defaults().key()).isEqualTo("quadric default");
        assertThat(EncoderSettings.defaults().withThreads(7).key()).isEqualTo("quadric default");
        assertThat(different().stream().map(EncoderSettings::key)).doesNotHaveDuplicates();
        assertThat(EncoderSettings.defaults()
                        .withSimplifier(Simplifier.PAPER)
                        .withLevels(List.of(.25, .5))
                        .withKeepOrder(true)
                        .key())
                .isEqualTo("paper levels=0.25,0.5 keep-order");
    }

    private static List<EncoderSettings> different() {
        EncoderSettings settings = EncoderSettings.defaults();
        return List.of(
                settings,
                settings.withBaseFaces(7),
                settings.withKeepOrder(true),
                settings.withQuality(Quality.FAST),
                settings.withQuality(Quality.BEST),
                settings.withUp(UpAxis.Y),
                settings.withUp(UpAxis.Z),
                settings.withPoster(false),
                settings.withSimplifier(Simplifier.PAPER),
                settings.withSimplifier(Simplifier.PAPER).withQuality(Quality.FAST),
                settings.withSimplifier(Simplifier.PAPER).withQuality(Quality.BEST),
                settings.withSimplifier(Simplifier.PAPER).withLevels(List.of(.25, .5)),
                settings.withSimplifier(Simplifier.PAPER).withLevels(List.of(.25)));
    }
}
