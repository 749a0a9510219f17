package org.jsmesh.archive;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class PlainTextTest {
    @Test
    void shouldLeaveTextOfAllScriptsAsItIs() {
        String text = "Räder 车轮 \ud83d\ude97 עברית <b>&amp;";
        assertThat(PlainText.of(text)).isEqualTo(text);
    }

    @Test
    void shouldReplaceControlsAndHalvesOfPairs() {
        assertThat(PlainText.of("a\tb\u007f\u009bc\u2028\u200f\ud83dx\ude97"))
                .isEqualTo("a\ufffdb\ufffd\ufffdc\ufffd\ufffd\ufffdx\ufffd");
    }

    @Test
    void shouldNotCutAPairInHalves() {
        assertThat(PlainText.cut("ab\ud83d\ude97cd", 4)).isEqualTo("ab…");
        assertThat(PlainText.cut("abcd", 4)).isEqualTo("abcd");
    }
}
