package org.jsmesh.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class JsonTest {
    @Test
    void shouldSeparateMembersAndElements() {
        Json json = new Json()
                .open('{')
                .key("a")
                .number(1)
                .key("b")
                .open('[')
                .number(.5)
                .number(-3)
                .close(']');
        json.key("c").open('{').close('}').key("d").flag(true).close('}');
        assertThat(json.toString()).isEqualTo("{\"a\":1,\"b\":[5e-1,-3],\"c\":{},\"d\":true}");
    }

    @Test
    void shouldEscapeWhatJsonDoesNotAllowInText() {
        assertThat(new Json().text("a\"b\\c\n").toString()).isEqualTo("\"a\\\"b\\\\c\\u000a\"");
    }

    @Test
    void shouldWriteNumbersThatJsonLacksAsNull() {
        Json json = new Json()
                .open('[')
                .number(Double.NaN)
                .number(Double.POSITIVE_INFINITY)
                .text(null)
                .close(']');
        assertThat(json.toString()).isEqualTo("[null,null,null]");
    }

    /** A parser gives the same double back. */
    @ParameterizedTest
    @ValueSource(
            doubles = {
                .1,
                -.1f,
                1 / 3.,
                Math.PI * 1e9,
                0x1p53 + 2,
                Long.MAX_VALUE,
                -0x1p63,
                1e300,
                Double.MAX_VALUE,
                Float.MIN_VALUE,
                Double.MIN_NORMAL,
                Double.MIN_VALUE,
                1e-300,
                -0.
            })
    void shouldWriteEveryNumberAsItIs(double number) {
        String text = new Json().number(number).toString();
        assertThat(text).matches("-?(0|[1-9][0-9]*)(e-[0-9]+)?");
        assertThat(Double.parseDouble(text)).isEqualTo(number + 0);
        assertThat(new BigDecimal(text)).isEqualByComparingTo(new BigDecimal(number));
    }

    @Test
    void shouldWriteZerosWithinANumber() {
        assertThat(new Json().number(0x1p-30 + 1).toString()).isEqualTo("1000000000931322574615478515625e-30");
        assertThat(new Json().number(1e22).toString()).isEqualTo("10000000000000000000000");
    }
}
