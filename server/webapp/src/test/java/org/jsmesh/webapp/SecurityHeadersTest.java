package org.jsmesh.webapp;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SecurityHeadersTest {
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '"',
            value = {
                "\"\" | frame-ancestors 'self'",
                "https://a.example | frame-ancestors 'self' https://a.example",
                "https://a.example https://b.example | frame-ancestors 'self' https://a.example https://b.example",
                "https://a.example * | frame-ancestors *"
            })
    void shouldSayWhoMayFrameThePage(String embedders, String rule) {
        List<String> origins = embedders.isEmpty() ? List.of() : List.of(embedders.split(" "));
        assertThat(SecurityHeaders.ofPages(origins).get("Content-Security-Policy"))
                .startsWith("default-src 'none'; ")
                .endsWith("; " + rule);
    }
}
