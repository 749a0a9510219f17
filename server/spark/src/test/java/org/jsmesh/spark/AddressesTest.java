package org.jsmesh.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class AddressesTest {
    @ParameterizedTest
    @CsvSource({
        "s3://public/models, s3://public/models",
        "s3://public/models/, s3://public/models",
        "s3://public/models///, s3://public/models",
        "s3://public//, s3://public",
        "s3://public, s3://public",
        "s3://, s3://",
        "/, /",
        "/tmp/x//, /tmp/x",
        "/tmp/../x/., /x",
        "file:///tmp/x/, /tmp/x",
        "file:/tmp/x, /tmp/x",
        "FILE:///tmp/a%20b%C3%BC, /tmp/a bü"
    })
    void shouldBeWithoutSlashesAtTheEnd(String given, String expected) {
        assertThat(Addresses.folder(given)).isEqualTo(expected);
    }

    @Test
    void shouldTakePathsFromTheFolderOfTheCommand() {
        String here = Path.of("").toAbsolutePath().toString();
        assertThat(Addresses.whole("x/y")).isEqualTo(here + "/x/y");
        assertThat(Addresses.whole("file:x")).isEqualTo(here + "/file:x");
        assertThat(Addresses.whole("s3://b/x/")).isEqualTo("s3://b/x/");
    }

    @ParameterizedTest
    @ValueSource(strings = {"file://host/x", "file:///a b", "file:///x?y"})
    void shouldRefuseWhatIsNoFileOfThisMachine(String given) {
        assertThatThrownBy(() -> Addresses.whole(given))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage(given + ": is no address of a file of this machine. Give its path");
    }

    @ParameterizedTest
    @CsvSource({
        "/a, /a, true",
        "/a/b, /a, true",
        "/a, /a/b, false",
        "/ab, /a, false",
        "/-report, /, true",
        "s3://b/a/c, s3://b/a, true",
        "s3://b/a-report, s3://b/a, false",
        "s3://b/a, s3://b, true",
        "s3://bc, s3://b, false"
    })
    void shouldTellWhatLiesInAnother(String inner, String outer, boolean expected) {
        assertThat(Addresses.isWithin(inner, outer)).isEqualTo(expected);
    }
}
