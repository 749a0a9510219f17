package org.jsmesh.app.server;

import static org.assertj.core.api.Assertions.assertThat;

import org.eclipse.jetty.io.ByteArrayEndPoint;
import org.junit.jupiter.api.Test;

class StreamProgressTest {
    @Test
    void shouldShareTheTimeOfAConnection() {
        StreamProgress pace = new StreamProgress();
        pace.look(1000, 1400, 4);
        pace.look(1000, 1800, 4);
        assertThat(pace.spentNanos()).isEqualTo(200);
        // The others are done: what they took is not held against it.
        pace.look(1000, 1900, 1);
        assertThat(pace.spentNanos()).isEqualTo(300);
    }

    @Test
    void shouldBeginAnewWithEveryPortion() {
        StreamProgress pace = new StreamProgress();
        pace.look(1000, 5000, 1);
        pace.look(5500, 6000, 1);
        assertThat(pace.spentNanos()).isEqualTo(500);
        assertThat(pace.sinceNanos()).isEqualTo(5500);
    }

    @Test
    void shouldKnowSinceWhenAConnectionHasNotTakenAPortion() {
        Peer peer = new Peer(new ByteArrayEndPoint(), null, false, false);
        peer.watch(true, 10, 100);
        peer.watch(true, 10 + Limits.PORTION_BYTES - 1, 200);
        assertThat(peer.movedNanos()).isEqualTo(100);
        peer.watch(true, 10 + Limits.PORTION_BYTES, 300);
        assertThat(peer.movedNanos()).isEqualTo(300);
        peer.watch(true, 11 + Limits.PORTION_BYTES, 400);
        assertThat(peer.movedNanos()).isEqualTo(300);
        peer.watch(false, 11 + Limits.PORTION_BYTES, 500);
        assertThat(peer.movedNanos()).as("there was nothing to take").isEqualTo(500);
    }
}
