package org.jsmesh.app.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

/** How fast addresses may ask. */
class RequestRatesTest {
    private static final long SECOND = 1_000_000_000L;

    private final AtomicLong nanos = new AtomicLong(Long.MAX_VALUE - 5 * SECOND);

    private RequestRates rates(int perSecond, int burst) {
        Limits limits = Limits.defaults().withRequestRate(perSecond, burst);
        return new RequestRates(limits, nanos::get, new SplittableRandom(1));
    }

    private static int taken(RequestRates rates, String address, int asked) {
        int taken = 0;
        for (int i = 0; i < asked; i++) if (rates.take(address) == 0) taken++;
        return taken;
    }

    @Test
    void shouldGiveABurstAndThenARate() {
        RequestRates rates = rates(10, 30);
        assertThat(taken(rates, "192.0.2.1", 100)).isEqualTo(30);
        assertThat(rates.refused()).isEqualTo(70);
        assertThat(taken(rates, "192.0.2.2", 100)).isEqualTo(30);
        // The clock passes its end here, as it may.
        nanos.addAndGet(10 * SECOND);
        assertThat(taken(rates, "192.0.2.1", 100)).isEqualTo(30);
        nanos.addAndGet(SECOND);
        assertThat(taken(rates, "192.0.2.1", 100)).isEqualTo(10);
        // An hour of silence is not an hour's worth.
        nanos.addAndGet(3600 * SECOND);
        assertThat(taken(rates, "192.0.2.1", 100)).isEqualTo(30);
    }

    @Test
    void shouldSayWhenToComeAgain() {
        RequestRates rates = rates(1, 1);
        assertThat(rates.take("a")).isZero();
        assertThat(rates.take("a")).isEqualTo(1);
        nanos.addAndGet(SECOND - 1);
        assertThat(rates.take("a")).isEqualTo(1);
        nanos.addAndGet(1);
        assertThat(rates.take("a")).isZero();
    }

    @Test
    void shouldLimitNobodyWithoutARate() {
        assertThat(taken(rates(0, 1), "a", 10_000)).isEqualTo(10_000);
    }

    /** Of a hundred clients beside ten thousand others that take all they can, each still gets what is its own. */
    @Test
    void shouldNotLetOthersPay() {
        RequestRates rates = rates(10, 30);
        for (int i = 0; i < 10_000; i++) taken(rates, "198.51." + i / 256 + "." + i % 256, 31);
        int whole = 0;
        for (int i = 0; i < 100; i++) if (taken(rates, "203.0.113." + i, 30) == 30) whole++;
        assertThat(whole).isGreaterThan(85);
    }
}
