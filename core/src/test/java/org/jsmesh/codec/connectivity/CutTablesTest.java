package org.jsmesh.codec.connectivity;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CutTablesTest {
    interface Table {
        int value(int feature, int index);
    }

    @ParameterizedTest
    @CsvSource({"seed, 10", "grow, 11"})
    void shouldBeThoseOfTheDocument(String bit, int features) throws IOException {
        Table table = bit.equals("seed") ? CutTables::seed : CutTables::growth;
        List<String> rows = Files.readAllLines(Path.of("../docs/format.md")).stream()
                .filter(line -> line.matches("\\| " + bit + " \\| .* \\| `[^`]+` \\|"))
                .map(line -> line.substring(line.indexOf('`') + 1, line.lastIndexOf('`')))
                .toList();
        assertThat(rows).hasSize(features);
        for (int f = 0; f < features; f++)
            for (int i = 0; i < rows.get(f).length(); i++)
                assertThat(table.value(f, i))
                        .as(bit + " " + f + " " + i)
                        .isEqualTo(rows.get(f).charAt(i) - 'M');
    }
}
