package org.jsmesh.store;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class PauseTest {
    @Test
    void shouldDoubleWithEveryFailureInARow() {
        Pause pause = new Pause();
        assertThat(pause.isOn()).isFalse();
        long last = 0;
        for (int i = 0; i < 30; i++) {
            pause = pause.next();
            pause.begin(false);
            assertThat(pause.isOn()).isTrue();
            long least = Math.min(3600, 60L << Math.min(i, 20)) - 5;
            assertThat(pause.seconds()).isBetween(least, least + 5).isGreaterThanOrEqualTo(last - 5);
            last = pause.seconds();
        }
        pause.reset();
        assertThat(pause.isOn()).isFalse();
        Pause next = pause.next();
        next.begin(true);
        assertThat(next.seconds()).as("nothing is remembered").isLessThanOrEqualTo(5);
    }
}
