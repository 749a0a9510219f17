package org.jsmesh.web;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

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
        assertThat(json.toString()).isEqualTo("{\"a\":1,\"b\":[0.5,-3],\"c\":{},\"d\":true}");
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
}
