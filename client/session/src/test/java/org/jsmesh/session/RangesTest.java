package org.jsmesh.session;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RangesTest {
    @Test
    void shouldWriteRanges() {
        assertThat(Ranges.header(0, 100)).isEqualTo("bytes=0-99");
        assertThat(Ranges.header(5, -1)).isEqualTo("bytes=5-");
    }

    @Test
    void shouldReadContentRanges() {
        assertThat(Ranges.parse("bytes 5-9/20")).isEqualTo(new Ranges.ContentRange(5, 10, 20));
        assertThat(Ranges.parse(" bytes 0-0/* ")).isEqualTo(new Ranges.ContentRange(0, 1, -1));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "bytes */20",
                "bytes 9-5/20",
                "bytes 5-20/20",
                "lines 1-2/3",
                "bytes 1-99999999999999999999/*"
            })
    void shouldRefuseWhatIsNoRange(String value) {
        assertThat(Ranges.parse(value)).isNull();
    }

    @Test
    void shouldJoinRangesByStrongTagsAlone() {
        assertThat(Ranges.strongTag("\"abc\"")).isEqualTo("\"abc\"");
        assertThat(Ranges.strongTag("W/\"abc\"")).isNull();
        assertThat(Ranges.strongTag(null)).isNull();
        assertThat(Ranges.strongTag("\"")).isNull();
    }
}
