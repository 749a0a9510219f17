package org.jsmesh.servlet.http;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Digests of bodies; the values are those of RFC 9530, appendices B and D, for the content that stands there. */
class BodyDigestsTest {
    private static final String CONTENT = "{\"hello\": \"world\"}\n";
    private static final String SHA_256 = "RK/0qy18MlBSVnWgjwz6lZEWjP/lF5HF9bvEF8FabDg=";
    private static final String SHA_512 =
            "YMAam51Jz/jOATT6/zvHrLVgOYTGFy1d6GJiOHTohq4yP+pgk4vf2aCsyRZOtw8MjkM7iw7yZ/WkppmM44T3qg==";

    private static boolean match(String... lines) throws IOException {
        BodyDigests digests = BodyDigests.of("Repr-Digest", List.of(lines));
        byte[] bytes = CONTENT.getBytes(StandardCharsets.UTF_8);
        assertThat(digests.watch(new ByteArrayInputStream(bytes)).readAllBytes())
                .isEqualTo(bytes);
        return digests.match();
    }

    @Test
    void shouldMatchWhatTheSenderMeans() throws IOException {
        assertThat(match()).isTrue();
        assertThat(match("sha-256=:" + SHA_256 + ":")).isTrue();
        assertThat(match("sha-256=:" + SHA_256.replace("=", "") + ":")).isTrue();
        assertThat(match("sha-512=:" + SHA_512 + ":")).isTrue();
        assertThat(match("sha-256=:" + SHA_256 + ":, sha-512=:" + SHA_512 + ":"))
                .isTrue();
        assertThat(match("sha-256=:" + SHA_256 + ":", "sha-512=:" + SHA_512 + ":"))
                .isTrue();
        assertThat(match(" sha-256=:" + SHA_256 + ":;a;b=1.5; c=\"d, \\\"e\" ")).isTrue();
        assertThat(match("md5=:AAAA:,sha-256=:" + SHA_256 + ":\t,\tsha=:AAAA:")).isTrue();
    }

    @Test
    void shouldTellOtherBytes() throws IOException {
        assertThat(match("sha-256=:" + SHA_256.replace('R', 'S') + ":")).isFalse();
        assertThat(match("sha-256=:" + SHA_256 + ":, sha-512=:" + SHA_512.replace('Y', 'Z') + ":"))
                .isFalse();
        // The last of one name counts.
        assertThat(match("sha-256=:" + SHA_256 + ":", "sha-256=:" + SHA_256.replace('R', 'S') + ":"))
                .isFalse();
        BodyDigests nothingRead = BodyDigests.of("Repr-Digest", List.of("sha-256=:" + SHA_256 + ":"));
        assertThat(nothingRead.match()).isFalse();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                " ",
                "sha-256",
                "sha-256=",
                "sha-256=" + SHA_256,
                "sha-256=\"" + SHA_256 + "\"",
                "SHA-256=:" + SHA_256 + ":",
                "sha-256 = :" + SHA_256 + ":",
                "sha-256=:AAAA:",
                "sha-256=:A:",
                "sha-256=:=AAA:",
                "sha-256=:" + SHA_256 + ":,",
                ",sha-256=:" + SHA_256 + ":",
                "sha-256=:" + SHA_256 + ":;",
                "sha-256=:" + SHA_256 + ": x",
                "md5=:AAA?:",
                "md5=1"
            })
    void shouldRefuseWhatIsNoDictionaryOfDigests(String line) {
        assertThatThrownBy(() -> BodyDigests.of("Repr-Digest", List.of(line)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("Repr-Digest");
    }

    /** A header of 8192 bytes must not cost more than it is long. */
    @ParameterizedTest
    @CsvSource({"';a=', 2000", "',a=:AAAA:', 800", "'=:', 4000"})
    void shouldReadLongFieldsAtOnce(String part, int times) {
        assertThatThrownBy(() ->
                        BodyDigests.of("Repr-Digest", List.of("sha-256=:" + SHA_256 + ":" + part.repeat(times) + "\"")))
                .isInstanceOf(IllegalArgumentException.class);
    }
}
