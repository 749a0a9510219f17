package org.jsmesh.app.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.BatchIndexBuilder;
import org.jsmesh.archive.BatchKind;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class SimulationTest {
    private static final BatchIndex INDEX = index();

    @Test
    void shouldFillTheWaitAtAConstantRate() {
        List<Simulation.Row> rows = new Simulation(INDEX, 1_000_000, 50).run(2000, 4);
        assertThat(rows).hasSize(4);
        for (int i = 1; i < rows.size(); i++) {
            assertThat(rows.get(i).waitMillis()).isBetween(1900.0, 2010.0);
            assertThat(rows.get(i).bytes() - rows.get(i - 1).bytes()).isBetween(200_000L, 275_000L);
            assertThat(rows.get(i).faces()).isGreaterThan(rows.get(i - 1).faces());
            assertThat(rows.get(i).errorMean()).isLessThan(rows.get(i - 1).errorMean());
        }
    }

    @Test
    void shouldEndWithTheOriginal() {
        List<Simulation.Row> rows = new Simulation(INDEX, 8_000_000, 20).run(2000, 100);
        Simulation.Row last = rows.get(rows.size() - 1);
        assertThat(last.bytes()).isEqualTo(INDEX.archiveBytes());
        assertThat(last.batches()).isEqualTo(INDEX.size());
        assertThat(rows).hasSizeLessThan(4);
    }

    /** Also where the last bytes arrive only after a deadline, which some of these rates bring about. */
    @ParameterizedTest
    @ValueSource(doubles = {100e3, 130e3, 170e3, 220e3, 290e3, 380e3, 500e3, 650e3, 850e3})
    void shouldShowTheOriginalAtAnyRate(double bitsPerSecond) {
        List<Simulation.Row> rows = new Simulation(INDEX, bitsPerSecond, 50).run(500, 1000);
        assertThat(rows.get(rows.size() - 1).batches()).isEqualTo(INDEX.size());
        for (int i = 1; i < rows.size(); i++)
            assertThat(rows.get(i).bytes()).isGreaterThan(rows.get(i - 1).bytes());
    }

    /** Nothing arrives before the first deadlines then, and what arrives after them must not be lost. */
    @ParameterizedTest
    @CsvSource({"64e3, 200, 300", "64e3, 200, 10000", "64e3, 100, 50", "1e6, 1, 50", "1e8, 50, 1000"})
    void shouldComeToTheOriginalWhereARoundTripTakesLongerThanTheWait(
            double bitsPerSecond, double waitMillis, double roundTripMillis) {
        List<Simulation.Row> rows = new Simulation(INDEX, bitsPerSecond, roundTripMillis).run(waitMillis, 20_000);
        assertThat(rows.get(rows.size() - 1).batches()).isEqualTo(INDEX.size());
    }

    @Test
    void shouldShowTheBaseLateRatherThanNothing() {
        Simulation.Row first = new Simulation(INDEX, 16_000, 50).run(2000, 1).get(0);
        // The packet that ends the base may hold a batch more.
        assertThat(first.batches()).isBetween(1, 2);
        assertThat(first.waitMillis()).isGreaterThan(2000);
    }

    @Test
    void shouldGiveAFasterLinkMoreDetail() {
        assertThat(new Simulation(INDEX, 2_000_000, 50).run(2000, 1).get(0).faces())
                .isGreaterThan(
                        new Simulation(INDEX, 64_000, 50).run(2000, 1).get(0).faces());
    }

    private static BatchIndex index() {
        BatchIndexBuilder builder =
                new BatchIndexBuilder().add(BatchKind.BASE, 12_000, 0).after(300, 152, 2);
        for (int i = 1; i <= 60; i++) {
            builder.add(BatchKind.SPLITS, 600 * i, 100 * i).after(300 + 200 * i, 152 + 100 * i, 2 - i / 30.0);
        }
        return builder.build();
    }
}
