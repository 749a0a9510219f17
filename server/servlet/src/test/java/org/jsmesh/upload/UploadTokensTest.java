package org.jsmesh.upload;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Who may send models. */
class UploadTokensTest {
    @TempDir
    private Path folder;

    @Test
    void shouldKnowWhatATokenIsGoodFor() throws IOException {
        UploadTokens tokens = UploadTokens.read(
                Files.writeString(folder.resolve("tokens"), "# who\n\n0123456789abcdef\nfedcba9876543210 chair-\n"));
        assertThat(tokens.check("0123456789abcdef", "table")).isEqualTo(UploadTokens.Verdict.GOOD);
        assertThat(tokens.check("fedcba9876543210", "chair-1")).isEqualTo(UploadTokens.Verdict.GOOD);
        assertThat(tokens.check("fedcba9876543210", "table")).isEqualTo(UploadTokens.Verdict.ELSEWHERE);
        assertThat(tokens.check("0123456789abcdeF", "table")).isEqualTo(UploadTokens.Verdict.UNKNOWN);
        assertThat(tokens.check("", "table")).isEqualTo(UploadTokens.Verdict.UNKNOWN);
    }

    @Test
    void shouldKnowHowMuchIsKeptForAToken() throws IOException {
        UploadTokens tokens = UploadTokens.read(
                Files.writeString(
                        folder.resolve("tokens"),
                        "0123456789abcdef quota=5G models=100\nfedcba9876543210 models=2 chair- quota=7\nfedcba9876543210 table-\n"));
        Sender all = tokens.sender("0123456789abcdef", "table");
        assertThat(all.mostBytes()).isEqualTo(5L << 30);
        assertThat(all.mostModels()).isEqualTo(100);
        Sender chairs = tokens.sender("fedcba9876543210", "chair-1");
        assertThat(chairs).isEqualTo(new Sender(chairs.key(), 7, 2));
        assertThat(chairs.key()).matches("[0-9a-f]{64}").isNotEqualTo(all.key());
        Sender tables = tokens.sender("fedcba9876543210", "table-1");
        assertThat(tables).isEqualTo(new Sender(chairs.key(), Long.MAX_VALUE, Integer.MAX_VALUE));
        assertThat(tokens.sender("fedcba9876543210", "stool")).isNull();
        assertThat(tokens.sender("0123456789abcdeF", "table")).isNull();
    }

    @ParameterizedTest
    @ValueSource(strings = {"quota=9999999999T", "quota=9223372036G"})
    void shouldTakeNoQuotaForLessThanItSays(String quota) throws IOException {
        Path file = Files.writeString(folder.resolve("tokens"), "0123456789abcdef " + quota);
        assertThat(UploadTokens.read(file).sender("0123456789abcdef", "x").mostBytes())
                .isEqualTo(Long.MAX_VALUE);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "0123456789abcdef quota=5X",
                "0123456789abcdef models=many",
                "0123456789abcdef faces=3",
                "",
                "# none\n",
                "short\n",
                "0123456789abcdef a b\n"
            })
    void shouldRefuseFilesWithoutTokens(String text) throws IOException {
        Path file = Files.writeString(folder.resolve("bad"), text);
        assertThatThrownBy(() -> UploadTokens.read(file))
                .isInstanceOf(FileSystemException.class)
                .hasMessageContaining("bad");
    }
}
