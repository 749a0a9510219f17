package org.jsmesh.desktop.panel;

import static org.assertj.core.api.Assertions.assertThat;

import org.jsmesh.session.SessionProgress;
import org.junit.jupiter.api.Test;

class FiguresTest {
    @Test
    void shouldGiveBytesInDecimalUnitsWithTwoDigitsOrMore() {
        assertThat(Figures.bytes(0)).isEqualTo("0 B");
        assertThat(Figures.bytes(999)).isEqualTo("999 B");
        assertThat(Figures.bytes(1000)).isEqualTo("1.0 kB");
        assertThat(Figures.bytes(9_949)).isEqualTo("9.9 kB");
        assertThat(Figures.bytes(9_950)).isEqualTo("10 kB");
        assertThat(Figures.bytes(999_499)).isEqualTo("999 kB");
        assertThat(Figures.bytes(999_500)).isEqualTo("1.0 MB");
        assertThat(Figures.bytes(1_234_000_000)).isEqualTo("1.2 GB");
    }

    @Test
    void shouldGiveErrorsWithTheDigitsThatCount() {
        assertThat(Figures.percent(0)).isEqualTo("0%");
        assertThat(Figures.percent(12.34)).isEqualTo("12%");
        assertThat(Figures.percent(1.234)).isEqualTo("1.2%");
        assertThat(Figures.percent(.01234)).isEqualTo("0.012%");
        assertThat(Figures.percent(.000123)).isEqualTo("0.0001%");
        assertThat(Figures.percent(1e-7)).isEqualTo("< 0.0001%");
    }

    @Test
    void shouldLeaveOutWhatIsNotKnownYet() {
        assertThat(Figures.line(new SessionProgress(1200, -1, 0, -1, 0, -1, 0, 0, 0), 0))
                .isEqualTo("1.2 kB");
        assertThat(Figures.line(new SessionProgress(1200, 50_000, 0, 9, 0, 1000, 0, 0, 2e4), 4))
                .isEqualTo("0 of 1,000 faces  ·  1.2 kB of 50 kB  ·  20 kB/s  ·  base mesh");
    }
}
