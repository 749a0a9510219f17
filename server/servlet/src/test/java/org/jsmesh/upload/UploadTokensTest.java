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

    @ParameterizedTest
    @ValueSource(strings = {"", "# none\n", "short\n", "0123456789abcdef a b\n"})
    void shouldRefuseFilesWithoutTokens(String text) throws IOException {
        Path file = Files.writeString(folder.resolve("bad"), text);
        assertThatThrownBy(() -> UploadTokens.read(file))
                .isInstanceOf(FileSystemException.class)
                .hasMessageContaining("bad");
    }
}
