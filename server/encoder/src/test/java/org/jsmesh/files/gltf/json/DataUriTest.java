package org.jsmesh.files.gltf.json;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class DataUriTest {
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "data:image/svg+xml,%3Csvg%3E+1|<svg>+1",
                "data:,a%20b|a b",
                "DATA:text/plain;BASE64,YSBi|a b",
                "data:;base64,YSBi|a b",
                "data:;base64,YS%42i|a b",
                "data:;base64,Pj8%2B|>?>"
            })
    void shouldDecodeDataWithAndWithoutBase64(String uri, String data) {
        assertThat(DataUri.is(uri)).isTrue();
        assertThat(DataUri.bytes(uri)).isEqualTo(data.getBytes(StandardCharsets.ISO_8859_1));
    }

    @Test
    void shouldKeepEscapedBytesAsTheyAre() {
        assertThat(DataUri.bytes("data:,%89%ff%00")).containsExactly(0x89, 0xFF, 0);
    }

    @ParameterizedTest
    @ValueSource(strings = {"data:", "data:;base64,A", "data:,%zz"})
    void shouldDecodeNothingElse(String uri) {
        assertThat(DataUri.bytes(uri)).isNull();
    }

    @ParameterizedTest
    @CsvSource({"a%2520b.png,a%20b.png", "a+b%C3%A9,a+bé", "100%,"})
    void shouldDecodeEscapesOnce(String uri, String path) {
        assertThat(DataUri.percentDecoded(uri)).isEqualTo(path);
    }
}
