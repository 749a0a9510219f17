package org.jsmesh.desktop.draw;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

class PaletteTest {
    private static final Path PAGE = Path.of("../web/src/main/js/levels/palette.js");

    @Test
    void shouldHaveTheColoursOfThePage() throws IOException {
        String stops = Files.readString(PAGE)
                .lines()
                .filter(line -> line.startsWith("const STOPS"))
                .findFirst()
                .orElseThrow();
        List<String> found = Pattern.compile("0x[0-9a-f]{6}")
                .matcher(stops)
                .results()
                .map(MatchResult::group)
                .toList();
        assertThat(found).hasSize(Palette.size());
        for (int i = 0; i < found.size(); i++)
            assertThat(Palette.of(i / (found.size() - 1.))).isEqualTo(Color.decode(found.get(i)));
    }

    @Test
    void shouldStayAtItsEndsAndMixBetween() {
        assertThat(Palette.of(-1)).isEqualTo(Palette.of(0));
        assertThat(Palette.of(7)).isEqualTo(Palette.of(1));
        assertThat(Palette.of(.5 / 9)).isEqualTo(new Color(0x46, 0x15, 0x66));
    }
}
