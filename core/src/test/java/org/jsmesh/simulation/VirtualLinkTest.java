package org.jsmesh.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class VirtualLinkTest {
    private static final double ROUND_TRIP_MILLIS = 40;

    @ParameterizedTest
    @CsvSource({"64e3", "256e3", "1e6", "10e6", "100e6"})
    void shouldDeliverWhatTheLinkCarries(double bitsPerSecond) {
        VirtualLink link = link(bitsPerSecond, HttpVersion.HTTP_1_1);
        long bytes = (long) (bitsPerSecond / 8 * 10);
        double taken = read(link, bytes);
        // Ten seconds' worth, a handshake, a round trip, and the slow start of a fast link.
        assertThat(taken).isBetween(10_080.0, 10_600.0);
        assertThat(link.wastedBytes()).isZero();
    }

    @Test
    void shouldStartSlowly() {
        VirtualLink link = link(100e6, HttpVersion.HTTP_1_1);
        assertThat(read(link, 14_000)).isCloseTo(82, within(5.0));
        // Three more round trips: 14, 28, 56, 112 kB.
        assertThat(read(link(100e6, HttpVersion.HTTP_1_1), 200_000)).isBetween(190.0, 260.0);
    }

    @Test
    void shouldKeepTheConnectionWarmForTheNextRequest() {
        VirtualLink link = link(10e6, HttpVersion.HTTP_1_1);
        read(link, 2_000_000);
        assertThat(read(link, 125_000)).isBetween(135.0, 160.0);
    }

    @Test
    void shouldLoseAFewPacketsWhenAConnectionIsClosedAndConnectAnew() {
        VirtualLink link = link(1e6, HttpVersion.HTTP_1_1);
        readSome(link, 1_000_000, 2000);
        link.cancel();
        double before = link.now();
        assertThat(read(link, 10_000) - 80).isGreaterThan(80 + ROUND_TRIP_MILLIS);
        assertThat(link.wastedBytes()).isBetween(5_000L, 40_000L);
        assertThat(link.now()).isGreaterThan(before);
    }

    @Test
    void shouldLoseWhatTheServersKernelHoldsWhenAStreamIsReset() {
        VirtualLink link = link(256e3, HttpVersion.HTTP_2);
        readSome(link, 1_000_000, 2000);
        link.cancel();
        double taken = read(link, 10_000);
        // What was on its way comes first: more than a round's worth.
        assertThat(link.wastedBytes()).isGreaterThan(46_000);
        assertThat(taken).isGreaterThan(link.wastedBytes() / 32.0);
    }

    @ParameterizedTest
    @EnumSource(HttpVersion.class)
    void shouldCountEveryByteAsReceivedOrWasted(HttpVersion version) {
        VirtualLink link = link(2e6, version);
        long received = readSome(link, 300_000, 1000);
        link.cancel();
        received += readSome(link, 500_000, 10_000);
        assertThat(link.isBusy()).isFalse();
        assertThat(received).isGreaterThan(500_000);
        assertThat(received + link.wastedBytes()).isLessThanOrEqualTo(800_000);
    }

    @Test
    void shouldKnowTheMostThatCouldArrive() {
        VirtualLink link = link(10e6, HttpVersion.HTTP_1_1);
        long first = link.mostBytes(0, 2000);
        long second = link.mostBytes(2000, 4000);
        assertThat(first).isBetween(2_200_000L, 2_400_000L);
        assertThat(second).isBetween(2_430_000L, 2_460_000L);
    }

    private static VirtualLink link(double bitsPerSecond, HttpVersion version) {
        return new VirtualLink(t -> bitsPerSecond, bitsPerSecond, version, ROUND_TRIP_MILLIS, 0);
    }

    /** Milliseconds until a response is complete. */
    private static double read(VirtualLink link, long bytes) {
        double start = link.now();
        link.ask(bytes);
        while (link.isBusy()) link.advance();
        return link.now() - start;
    }

    /** Bytes that arrive of a response within some time. */
    private static long readSome(VirtualLink link, long bytes, double millis) {
        double end = link.now() + millis;
        long received = 0;
        link.ask(bytes);
        while (link.isBusy() && link.now() < end) received += link.advance();
        return received;
    }
}
