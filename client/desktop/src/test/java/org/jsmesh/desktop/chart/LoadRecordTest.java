package org.jsmesh.desktop.chart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class LoadRecordTest {
    private final LoadRecord load = new LoadRecord();

    @Test
    void shouldGiveTheRateOfEachPartOfTheTime() {
        load.sample(1000, true, 0, 0, 0);
        load.sample(2000, true, 1000, 10, 1);
        load.sample(3000, true, 5000, 50, .5);
        assertThat(load.seconds()).isEqualTo(2);
        assertThat(load.rates(2)).containsExactly(1000, 4000);
        assertThat(load.rates(4)).containsExactly(1000, 1000, 4000, 4000);
        assertThat(load.faces(2)).containsExactly(10, 50);
        assertThat(load.errors(2)).containsExactly(1, .5);
    }

    @Test
    void shouldLeaveOutWhatPassesBetweenRounds() {
        load.sample(0, true, 0, 0, 0);
        load.sample(1000, false, 500, 5, 2);
        load.sample(60_000, true, 700, 7, 2);
        load.sample(61_000, false, 1700, 17, 1);
        assertThat(load.seconds()).isEqualTo(2);
        assertThat(load.rates(2)).containsExactly(500, 1000);
        assertThat(load.faces(2)).containsExactly(7, 17);
    }

    @Test
    void shouldShowNothingBeforeThereIsAnything() {
        assertThat(load.rates(3)).containsOnly(0);
        assertThat(load.faces(3)).containsOnly(0);
        load.sample(0, true, 10, 0, 0);
        load.sample(1000, true, 20, 0, 0);
        assertThat(load.errors(2)).containsOnly(Double.NaN);
    }

    @Test
    void shouldShowPausesOfTheLink() {
        long[] bytes = {0, 100, 100, 100, 200};
        for (int i = 0; i < bytes.length; i++) load.sample(1000L * i, true, bytes[i], 0, 0);
        assertThat(load.rates(4)).containsExactly(100, 0, 0, 100);
    }

    @Test
    void shouldBeginAgainWithTheModel() {
        load.sample(0, true, 0, 0, 0);
        load.sample(1000, true, 500, 5, 2);
        load.sample(2000, true, 100, 1, 3);
        load.sample(3000, true, 300, 3, 2);
        assertThat(load.seconds()).isEqualTo(1);
        assertThat(load.rates(1)).containsExactly(200);
    }

    @Test
    void shouldNotGrowForEver() {
        int samples = 100_000;
        for (int i = 0; i <= samples; i++) load.sample(10L * i, true, 100L * i, i, 1.0 / (i + 1));
        assertThat(load.size()).isBetween(LoadRecord.MOST / 4, LoadRecord.MOST);
        assertThat(load.seconds()).isEqualTo(samples / 100.0, within(1e-6));
        assertThat(load.faces(4)[3]).isEqualTo(samples);
        for (double rate : load.rates(10)) assertThat(rate).isEqualTo(10_000, within(100.0));
    }

    @Test
    void shouldDrawErrorsByTheirLogarithm() {
        assertThat(LoadChart.logarithms(new double[] {Double.NaN, 10, 1, 1e-9, 0}))
                .containsExactly(new double[] {Double.NaN, 1, .8, 0, 0}, within(1e-9));
    }
}
