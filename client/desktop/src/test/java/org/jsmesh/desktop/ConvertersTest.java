package org.jsmesh.desktop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine.TypeConversionException;

class ConvertersTest {
    @ParameterizedTest
    @CsvSource({"2s,2000", "1.5s,1500", "500ms,500", "3,3000", "3600s,3600000"})
    void shouldReadTimes(String text, int millis) {
        assertThat(new WaitConverter().convert(text)).isEqualTo(millis);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "s", "0s", "-1s", "2m", "3601s", "0.0001s", "99999999s", "1e3s"})
    void shouldRefuseOtherTimesInWords(String text) {
        assertThatThrownBy(() -> new WaitConverter().convert(text))
                .isInstanceOf(TypeConversionException.class)
                .hasMessageContaining("'" + text + "'");
    }

    @Test
    void shouldReadSizes() {
        assertThat(new SizeConverter().convert("640x480")).isEqualTo(new PictureSize(640, 480));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "640", "0x10", "640x480x3", "9000x10", "-1x5", "99999999x1"})
    void shouldRefuseOtherSizesInWords(String text) {
        assertThatThrownBy(() -> new SizeConverter().convert(text))
                .isInstanceOf(TypeConversionException.class)
                .hasMessageContaining("'" + text + "'");
    }
}
