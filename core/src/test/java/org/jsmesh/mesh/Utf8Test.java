package org.jsmesh.mesh;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class Utf8Test {
    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "a\u0000\u007f",
                "\u0080\u07ff",
                "\u0800\ud7ff\ue000\uffff",
                "\ud800\udc00\udbff\udfff",
                "é𝄞ß"
            })
    void shouldWriteAndReadWhatTheClassLibraryDoes(String text) {
        byte[] bytes = text.getBytes(UTF_8);
        assertThat(Utf8.bytes(text)).isEqualTo(bytes);
        assertThat(Utf8.text(bytes, 0, bytes.length)).isEqualTo(text);
    }

    @ParameterizedTest
    @ValueSource(strings = {"\ud800", "\udc00", "\ud800a", "\ud800\ud800\udc00", "\udc00\ud800"})
    void shouldWriteHalfASurrogateAsAQuestionMark(String text) {
        assertThat(Utf8.bytes(text)).isEqualTo(text.getBytes(UTF_8)).contains('?');
    }

    @Test
    void shouldReadAPartOfAnArray() {
        assertThat(Utf8.text("aé𝄞b".getBytes(UTF_8), 1, 6)).isEqualTo("é𝄞");
        assertThat(Utf8.text("aé𝄞b".getBytes(UTF_8), 1, 4)).isEqualTo("é\ufffd");
    }

    /** All beginnings of two bytes, then what may end them. */
    @Test
    void shouldReadBadBytesAsTheClassLibraryDoes() {
        int[] ends = {0x00, 0x41, 0x7f, 0x80, 0x8f, 0x90, 0x9f, 0xa0, 0xbf, 0xc0, 0xe2, 0xff};
        for (int pair = 0; pair < 1 << 16; pair++) {
            for (int end : ends) {
                byte[] bytes = {(byte) (pair >> 8), (byte) pair, (byte) end, (byte) 0x80};
                assertThat(Utf8.text(bytes, 0, 4)).as("%04x %02x", pair, end).isEqualTo(new String(bytes, UTF_8));
            }
        }
    }

    @Test
    void shouldReadAnyBytesAsTheClassLibraryDoes() {
        Random random = new Random(1);
        for (int i = 0; i < 20_000; i++) {
            byte[] bytes = new byte[random.nextInt(12)];
            for (int k = 0; k < bytes.length; k++)
                bytes[k] = (byte) (random.nextInt(4) == 0 ? 'x' : 128 + random.nextInt(128));
            assertThat(Utf8.text(bytes, 0, bytes.length))
                    .as(Arrays.toString(bytes))
                    .isEqualTo(new String(bytes, UTF_8));
        }
    }
}
