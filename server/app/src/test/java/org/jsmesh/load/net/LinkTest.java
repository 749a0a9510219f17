package org.jsmesh.load.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.assertj.core.data.Percentage;
import org.junit.jupiter.api.Test;

class LinkTest {
    @Test
    void shouldLetPassWhatItsRateCarries() {
        Link link = new Link(1e6, 40);
        long bytes = 0;
        double now = 1000;
        link.allowance(now);
        link.took(link.allowance(now), true);
        while (now < 11_000) {
            now = Math.max(now, link.readyMillis());
            int n = link.allowance(now);
            assertThat(n).isPositive();
            link.took(n, false);
            bytes += n;
        }
        assertThat(bytes).isCloseTo(1_250_000, Percentage.withPercentage(1));
        assertThat(link.carries(10_000)).isCloseTo(1_250_000, within(1e-6));
    }

    @Test
    void shouldLoseTheTimeInWhichNothingWaits() {
        Link link = new Link(1e6, 40);
        link.allowance(0);
        link.took(100, true);
        assertThat(link.allowance(5000)).isPositive().isLessThan(3000);
    }

    @Test
    void shouldCatchUpWithWhatWaitedForABusyReader() {
        Link link = new Link(1e6, 40);
        link.allowance(1000);
        link.took(100, false);
        assertThat(link.allowance(1500)).isBetween(62_000, 66_000);
    }

    @Test
    void shouldLetNothingPassWhileBlocked() {
        Link link = new Link(1e6, 40);
        link.allowance(1000);
        link.took(100, false);
        link.blockUntil(4000);
        assertThat(link.allowance(3999)).isZero();
        assertThat(link.readyMillis()).isEqualTo(4000);
        assertThat(link.allowance(4100)).isPositive().isLessThan(20_000);
    }
}
