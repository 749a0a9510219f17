package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class WaitTest {
    @ParameterizedTest
    @CsvSource({"2s,2000", "500ms,500", "1.5,1500", "0.25s,250", "3,3000"})
    void shouldReadSecondsAndMilliseconds(String text, int millis) {
        assertThat(Wait.parse(text).millis()).isEqualTo(millis);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "s", "-1s", "2 h", "0", "0ms", "NaN", "1e3s"})
    void shouldRefuseAnythingElse(String text) {
        assertThatThrownBy(() -> Wait.parse(text)).isInstanceOf(picocli.CommandLine.TypeConversionException.class);
    }
}
