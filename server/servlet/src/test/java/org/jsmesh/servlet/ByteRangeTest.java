package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ByteRangeTest {
    @ParameterizedTest
    @CsvSource({
        "bytes=0-0, 0, 1",
        "bytes=0-99, 0, 100",
        "bytes=10-19, 10, 10",
        "bytes=10-, 10, 90",
        "bytes=99-, 99, 1",
        "bytes=90-200, 90, 10",
        "bytes=-1, 99, 1",
        "bytes=-100, 0, 100",
        "bytes=-500, 0, 100",
        "BYTES=10-19, 10, 10",
        "bytes= 10 - 19 , 10, 10",
        "bytes=0010-00000000000000000000019, 10, 10",
        "bytes=0-99999999999999999999999, 0, 100",
    })
    void shouldServeOneRange(String field, long first, long length) {
        assertThat(ByteRange.parse(field, 100)).isEqualTo(new ByteRange(ByteRange.Kind.PART, first, length));
    }

    @ParameterizedTest
    @ValueSource(strings = {"bytes=100-", "bytes=100-200", "bytes=-0", "bytes=99999999999999999999-"})
    void shouldRefuseRangesBehindTheEnd(String field) {
        assertThat(ByteRange.parse(field, 100).kind()).isEqualTo(ByteRange.Kind.UNSATISFIABLE);
        assertThat(ByteRange.parse(field, 100).contentRange(100)).isEqualTo("bytes */100");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "bytes",
                "bytes=",
                "bytes=-",
                "bytes=5-4",
                "bytes=a-b",
                "bytes=0-1,5-6",
                "items=0-1",
                "bytes=1-2-3",
                "bytes=--1"
            })
    void shouldAnswerAnythingElseWithTheWhole(String field) {
        assertThat(ByteRange.parse(field, 100)).isEqualTo(ByteRange.whole(100));
    }

    @Test
    void shouldAnswerNoRangeWithTheWhole() {
        assertThat(ByteRange.parse(null, 100)).isEqualTo(new ByteRange(ByteRange.Kind.WHOLE, 0, 100));
    }

    @Test
    void shouldCountBeyondTwoGigabytes() {
        long total = 5_000_000_000L;
        ByteRange range = ByteRange.parse("bytes=4294967296-4294967305", total);
        assertThat(range).isEqualTo(new ByteRange(ByteRange.Kind.PART, 4_294_967_296L, 10));
        assertThat(range.contentRange(total)).isEqualTo("bytes 4294967296-4294967305/5000000000");
    }
}
