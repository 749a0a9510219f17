package org.jsmesh.secret;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import org.jsmesh.secret.SignKeys.Verdict;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Addresses that only the owner of a key can make. */
class SignKeysTest {
    private static final String OLD = "0123456789abcdef0123456789abcdef";
    private static final String NEW = "fedcba9876543210fedcba9876543210";
    private static final Instant UNTIL = Instant.ofEpochSecond(2_000_000_000);
    private static final Instant BEFORE = UNTIL.minusSeconds(1);

    @TempDir
    private Path folder;

    private SignKeys keys(String... lines) throws IOException {
        return SignKeys.read(Files.write(folder.resolve("keys"), List.of(lines)));
    }

    /**
     * The value was computed with OpenSSL: {@code printf 'jsm-address-1\nchair\n2000000000' | openssl dgst -sha256
     * -hmac KEY -binary}.
     */
    @Test
    void shouldSignAsSpecified() throws IOException {
        assertThat(keys(OLD).query("chair", UNTIL))
                .isEqualTo("expires=2000000000&signature=E9bEChThh79GDnZMn7iqUw_CbfplrJpYH89rW7tRPzc");
    }

    @Test
    void shouldOpenOneModelUntilTheTimeIsOver() throws IOException {
        SignKeys keys = keys(OLD);
        String query = keys.query("chair", UNTIL);
        assertThat(keys.verify("chair", query, BEFORE)).isEqualTo(Verdict.GOOD);
        assertThat(keys.verify("chair", "from=3&" + query + "&waitMillis=1", BEFORE))
                .isEqualTo(Verdict.GOOD);
        assertThat(keys.verify("chair", query, UNTIL)).isEqualTo(Verdict.EXPIRED);
        assertThat(keys.verify("chair-1", query, BEFORE)).isEqualTo(Verdict.WRONG);
        assertThat(keys.verify(SignKeys.ALL, query, BEFORE)).isEqualTo(Verdict.WRONG);
        assertThat(keys.verify("chair", query.replace("2000000000", "2000000001"), BEFORE))
                .isEqualTo(Verdict.WRONG);
        assertThat(keys.verify("chair", null, BEFORE)).isEqualTo(Verdict.NONE);
        assertThat(keys.verify("chair", "a=b", BEFORE)).isEqualTo(Verdict.NONE);
        assertThat(SignKeys.of("from=3&" + query)).isEqualTo(query);
        assertThat(SignKeys.of("from=3")).isNull();
        String all = keys.query(SignKeys.ALL, UNTIL);
        assertThat(keys.verify("chair", all, BEFORE)).isEqualTo(Verdict.GOOD);
        assertThat(keys.verify(SignKeys.ALL, all, BEFORE)).isEqualTo(Verdict.GOOD);
    }

    @Test
    void shouldLetKeysBeExchanged() throws IOException {
        String byOld = keys(OLD).query("chair", UNTIL);
        SignKeys both = keys("# the new one", NEW, OLD);
        assertThat(both.verify("chair", byOld, BEFORE)).isEqualTo(Verdict.GOOD);
        assertThat(both.query("chair", UNTIL))
                .isEqualTo(keys(NEW).query("chair", UNTIL))
                .isNotEqualTo(byOld);
        assertThat(keys(NEW).verify("chair", byOld, BEFORE)).isEqualTo(Verdict.WRONG);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "expires=2000000000",
                "signature=AAAA",
                "expires=&signature=",
                "expires=2000000000&signature=***",
                "expires=-1&signature=AAAA",
                "expires=02000000000&signature=AAAA",
                "expires=99999999999999999999&signature=AAAA",
                "expires=2000000000&expires=2000000000&signature=AAAA"
            })
    void shouldRefuseWhatIsNoSignature(String query) throws IOException {
        assertThat(keys(OLD).verify("chair", query, BEFORE)).isEqualTo(Verdict.WRONG);
    }

    @Test
    void shouldNotLetAParameterCountTwice() throws IOException {
        SignKeys keys = keys(OLD);
        String query = keys.query("chair", UNTIL);
        assertThat(keys.verify("chair", query + "&" + query, BEFORE)).isEqualTo(Verdict.WRONG);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "# none", "0123456789abcdef0123456789abcde"})
    void shouldRefuseFilesWithoutKeys(String line) {
        assertThatThrownBy(() -> keys(line))
                .isInstanceOf(FileSystemException.class)
                .hasMessageContaining("openssl rand");
    }
}
