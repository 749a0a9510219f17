package org.jsmesh.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class WindowRunTest {
    @Test
    void shouldNameTheWindowAfterTheModel() {
        assertThat(WindowRun.title("http://127.0.0.1:8080/m/bunny/manifest.json"))
                .isEqualTo("bunny");
        assertThat(WindowRun.title("http://127.0.0.1:8080/m/bunny/" + "0a".repeat(32) + ".jsm"))
                .isEqualTo("bunny");
        assertThat(WindowRun.title("https://example.org/a/horse.jsm?v=2")).isEqualTo("horse.jsm");
        assertThat(WindowRun.title("models/fandisk.jsm")).isEqualTo("fandisk.jsm");
        assertThat(WindowRun.title("C:\\models\\fandisk.jsm")).isEqualTo("fandisk.jsm");
        assertThat(WindowRun.title("/")).isEqualTo("/");
    }
}
