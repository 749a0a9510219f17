package org.jsmesh.load.net;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ReceiveWindowTest {
    private final ReceiveWindow window = new ReceiveWindow(1000);

    @Test
    void shouldGrantWhatIsUsedWhenThatIsHalf() {
        assertThat(window.take(499)).isTrue();
        assertThat(window.grant()).isZero();
        assertThat(window.take(1)).isTrue();
        assertThat(window.grant()).isEqualTo(500);
        assertThat(window.grant()).isZero();
        assertThat(window.take(1000)).isTrue();
        assertThat(window.grant()).isEqualTo(1000);
    }

    @Test
    void shouldNoticeMoreThanWasGranted() {
        assertThat(window.take(1000)).isTrue();
        assertThat(window.take(1)).isFalse();
    }
}
