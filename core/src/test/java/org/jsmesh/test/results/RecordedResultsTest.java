package org.jsmesh.test.results;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RecordedResultsTest {
    private static final String TEXT = """
            # Results

            ## First

            Some words.

            | model | reference | bytes | error | levels |
            |---|---:|---:|---:|---:|
            | a b.ply | 900 | 20000 | 0.01234 | 9 |
            | flat.obj | 900 | 10000 | 0 | 7 |
            | plain.obj | 900 |  | 0.5 | 7 |

            ## Second

            | model | bytes |
            |---|---:|
            | x | 7 |
            """;

    @TempDir
    private Path folder;

    private Path file;

    @BeforeEach
    void write() throws IOException {
        file = Files.writeString(folder.resolve("recorded.md"), TEXT);
    }

    private static ResultTable table() {
        return new ResultTable(
                "model",
                List.of(
                        ResultColumn.given("reference"),
                        ResultColumn.small("bytes"),
                        ResultColumn.small("error", 1e-5),
                        ResultColumn.same("levels")));
    }

    private RecordedResults recorded(boolean isRecording) {
        return new RecordedResults(file, "First", "mvn test", isRecording);
    }

    private void check(boolean isRecording, String row, double... figures) throws IOException {
        ResultTable measured = table();
        measured.put(row, figures);
        recorded(isRecording).check(measured);
    }

    @Test
    void shouldReadWhatItWrites() throws IOException {
        assertThat(recorded(false).read(table()).toLines())
                .isEqualTo(TEXT.lines().toList().subList(6, 11));
    }

    @ParameterizedTest
    @CsvSource({
        "a b.ply, 1, 20000, .01234, 9",
        "a b.ply, 1, 20099, .012399, 9",
        "a b.ply, 1, 15000, .01, 9",
        "flat.obj, 1, 10000, .000009, 7",
        "plain.obj, 900, NaN, .5, 7"
    })
    void shouldTakeWhatIsHardlyWorse(String row, double given, double bytes, double error, double levels) {
        assertThatCode(() -> check(false, row, given, bytes, error, levels)).doesNotThrowAnyException();
    }

    @ParameterizedTest
    @CsvSource({
        "a b.ply, 20200, .01234, 9, 'a b.ply, bytes: 20000 before, 20200 now (+1.00%)'",
        "a b.ply, 20000, .01241, 9, 'a b.ply, error: 0.01234 before, 0.01241 now (+0.57%)'",
        "a b.ply, 20000, .01234, 8, 'a b.ply, levels: 9 before, 8 now'",
        "flat.obj, 10000, .0000102, 7, 'flat.obj, error: 0 before, 0.0000102 now (+2.00%)'",
        "plain.obj, 5, .5, 7, 'plain.obj, bytes: none before, 5 now'",
        "a b.ply, NaN, .01234, 9, 'a b.ply, bytes: 20000 before, none now'",
        "new.obj, 5, .5, 7, 'new.obj: not recorded yet'"
    })
    void shouldNameWhatIsWorse(String row, double bytes, double error, double levels, String words) {
        assertThatThrownBy(() -> check(false, row, 900, bytes, error, levels))
                .isInstanceOf(AssertionError.class)
                .hasMessageContaining("1 figures of \"First\"")
                .hasMessageContaining(words)
                .hasMessageContaining("mvn test -Djsm.results=record");
        assertThat(file).hasContent(TEXT);
    }

    @Test
    void shouldRecordOneTableAlone() throws IOException {
        check(true, "flat.obj", 900, 12000, .00123456, 8);
        check(true, "new.obj", 700, 5, .5, 7);
        assertThat(file)
                .hasContent(TEXT.replace("| 10000 | 0 | 7 |", "| 12000 | 0.001235 | 8 |")
                        .replace("|  | 0.5 | 7 |", "|  | 0.5 | 7 |\n| new.obj | 700 | 5 | 0.5 | 7 |"));
    }

    @Test
    void shouldTellThatATableIsMissing() {
        assertThatThrownBy(() -> new RecordedResults(file, "Third", "", false).read(table()))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("recorded.md has no table below a heading \"## Third\"");
        assertThatThrownBy(() -> new RecordedResults(file, "Second", "", false).read(table()))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("the head of the table is not | model | reference |");
    }
}
