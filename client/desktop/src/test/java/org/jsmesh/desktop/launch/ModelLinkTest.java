package org.jsmesh.desktop.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ModelLinkTest {
    @ParameterizedTest
    @CsvSource({
        "jsm:https://example.org/m/chair/manifest.json, https://example.org/m/chair/manifest.json",
        "JSM:HTTP://127.0.0.1:8080/m/a/manifest.json?expires=1&signature=a-_, "
                + "HTTP://127.0.0.1:8080/m/a/manifest.json?expires=1&signature=a-_",
        "jsm:http://[::1]:8080/a.jsm, http://[::1]:8080/a.jsm",
        "jsm://example.org/m/chair/, https://example.org/m/chair/",
        "jsm:https://example.org/m/%E6%A4%85/manifest.json, https://example.org/m/%E6%A4%85/manifest.json"
    })
    void shouldLeadToTheAddressOfAModel(String link, String address) {
        assertThat(ModelLink.location(link)).isEqualTo(address);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "jsm:",
                "jsm://",
                "jsm:/etc/passwd",
                "jsm:///etc/passwd",
                "jsm:file:///etc/passwd",
                "jsm:C:\\models\\a.jsm",
                "jsm:\\\\host\\share\\a.jsm",
                "jsm:models/a.jsm",
                "jsm:-Dx=y",
                "jsm:--screenshot",
                "jsm:jar:https://example.org/a.jar!/x",
                "jsm:jsm:https://example.org/a.jsm",
                "jsm:https:",
                "jsm:https:a.jsm",
                "jsm:https://",
                "jsm:https://user@example.org/a.jsm",
                "jsm:https://example.org/a.jsm --screenshot x.png",
                "jsm:https://example.org/\"a",
                "jsm:https://example.org/a\n"
            })
    void shouldLeadNowhereElse(String link) {
        assertThatThrownBy(() -> ModelLink.location(link))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith(link)
                .hasMessageContaining("write jsm: in front of the address of a model");
    }

    @Test
    void shouldLeaveOtherArgumentsAsTheyAre() {
        for (String argument : new String[] {"a.jsm", "/models/jsm:a", "http://127.0.0.1:8080/a.jsm", "-", "jsm"})
            assertThat(ModelLink.location(argument)).isEqualTo(argument);
    }

    @Test
    void shouldOpenNothingBesideALink() {
        for (List<String> good :
                List.of(List.of("jsm:http://127.0.0.1/a.jsm"), List.of("a.jsm", "b.jsm"), List.<String>of()))
            assertThatCode(() -> ModelLink.requireAlone(good)).doesNotThrowAnyException();
        assertThatThrownBy(() -> ModelLink.requireAlone(List.of("jsm:http://127.0.0.1/a.jsm", "/etc/passwd")))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("stands alone");
    }

    @Test
    void shouldTakeAFileAsFileManagersNameIt() {
        Path file = Path.of("a folder", "a%b.jsm").toAbsolutePath();
        assertThat(ModelLink.location(file.toUri().toString())).isEqualTo(file.toString());
        assertThatThrownBy(() -> ModelLink.location("file:a b"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("give its path");
    }
}
