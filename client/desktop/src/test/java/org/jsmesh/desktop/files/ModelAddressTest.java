package org.jsmesh.desktop.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jsmesh.archive.coding.ArchiveLayout;
import org.jsmesh.desktop.files.ModelAddress.Kind;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ModelAddressTest {
    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource({
        "http://h:8080/?m=bunny, http://h:8080/m/bunny/manifest.json",
        "http://h:8080?m=bunny, http://h:8080/m/bunny/manifest.json",
        "https://h/base/?q=x&m=a%20b&up=z#camera=1, https://h/base/m/a%20b/manifest.json",
        "https://h/base/index.html?m=bunny, https://h/base/m/bunny/manifest.json",
        "https://h/m/bunny/, https://h/m/bunny/manifest.json",
        "https://h/base/m/bunny/index.html#shading=flat, https://h/base/m/bunny/manifest.json",
        "https://h/m/bunny, https://h/m/bunny/manifest.json",
        "https://h/m/bunny/?m=horse, https://h/m/horse/manifest.json",
        "https://h/?m=bunny&expires=9&signature=a-b_c, https://h/m/bunny/manifest.json?expires=9&signature=a-b_c",
        "https://h/m/bunny/?expires=9&signature=a%3D&up=z, https://h/m/bunny/manifest.json?expires=9&signature=a%3D",
        "jsm:http://h:8080/?m=bunny, http://h:8080/m/bunny/manifest.json",
        "jsm://h/m/bunny/, https://h/m/bunny/manifest.json",
        "https://h/?archive=https%3A%2F%2Fi%2Fa.jsm%3Fk%3D1, https://i/a.jsm?k=1",
        "https://h/base/?archive=a%20b.jsm, https://h/base/a%20b.jsm",
    })
    void shouldFindTheManifestOfAPage(String page, String manifest) {
        assertThat(ModelAddress.of(page)).isEqualTo(new ModelAddress(Kind.REMOTE, manifest));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "http://h/m/bunny/manifest.json",
                "http://h/m/bunny/manifest.json?expires=9&signature=abc",
                "http://h/m/bunny/0123.jsm?m=other",
                "https://h/models/bunny",
                "https://h/"
            })
    void shouldTakeOtherAddressesAsTheyAre(String address) {
        assertThat(ModelAddress.of(" " + address + "#part\n")).isEqualTo(new ModelAddress(Kind.REMOTE, address));
    }

    @Test
    void shouldKeepLettersBeyondAsciiOnTheWire() {
        assertThat(ModelAddress.of("http://h/?m=straße").location()).isEqualTo("http://h/m/stra%C3%9Fe/manifest.json");
    }

    @Test
    void shouldTellArchivesFromModels() throws IOException {
        Path odd = folder.resolve("archive.bin");
        Files.write(odd, ArchiveLayout.MAGIC);
        assertThat(ModelAddress.of(odd.toString()).kind()).isEqualTo(Kind.ARCHIVE);
        assertThat(ModelAddress.of("a.JSM").kind()).isEqualTo(Kind.ARCHIVE);
        assertThat(ModelAddress.of("a.obj").kind()).isEqualTo(Kind.MODEL);
        assertThat(ModelAddress.of("\"a b.ply.gz\"")).isEqualTo(new ModelAddress(Kind.MODEL, "a b.ply.gz"));
        assertThat(ModelAddress.of(odd.toUri().toString())).isEqualTo(new ModelAddress(Kind.ARCHIVE, odd.toString()));
    }

    @Test
    void shouldSayWhatIsNoAddress() {
        assertThatThrownBy(() -> ModelAddress.of(" ")).hasMessageContaining("no address");
        assertThatThrownBy(() -> ModelAddress.of("ftp://h/a.jsm"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("ftp://h/a.jsm is no http, https or file address");
        assertThatThrownBy(() -> ModelAddress.of("http://exa mple/")).hasMessageContaining("no address");
        assertThatThrownBy(() -> ModelAddress.of("jsm:file:///etc/passwd")).hasMessageContaining("leads to no address");
        assertThatThrownBy(() -> ModelAddress.of("http://h/?file=a.ply")).hasMessageContaining("open the file itself");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "jsm:https://h/?archive=file%3A%2F%2F%2Fetc%2Fpasswd",
                "https://h/?archive=file:/home/u/a.jsm",
                "https://h/?archive=FILE%3Aa.jsm",
                "https://h/?archive=jar:file:/a.jar!/a.jsm"
            })
    void shouldLeaveTheWebForNoPage(String page) {
        assertThatThrownBy(() -> ModelAddress.of(page))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("names no archive of http or https");
    }

    @Test
    void shouldNameTheModel() {
        assertThat(title("http://127.0.0.1:8080/m/bunny/manifest.json")).isEqualTo("bunny");
        assertThat(title("http://127.0.0.1:8080/?m=bunny&expires=1&signature=x"))
                .isEqualTo("bunny");
        assertThat(title("http://127.0.0.1:8080/m/bunny/" + "0a".repeat(32) + ".jsm"))
                .isEqualTo("bunny");
        assertThat(title("https://example.org/a/horse.jsm?v=2")).isEqualTo("horse.jsm");
        assertThat(title("models/fandisk.jsm")).isEqualTo("fandisk.jsm");
        assertThat(title("C:\\models\\fandisk.jsm")).isEqualTo("fandisk.jsm");
    }

    @Test
    void shouldNameTheModelInLettersForPeople() {
        assertThat(title("http://h/?m=straße 1".replace(" ", "%20"))).isEqualTo("straße 1");
        assertThat(title("http://h/m/a+b%2Bc/manifest.json")).isEqualTo("a+b+c");
        assertThat(title("http://h/100%.jsm".replace("%", "%25"))).isEqualTo("100%.jsm");
        assertThat(title("http://h/a%0A%E2%80%AE.jsm")).isEqualTo("a\ufffd\ufffd.jsm");
    }

    @ParameterizedTest
    @CsvSource({
        "http://h/m/bunny/manifest.json, bunny",
        "http://h/horse.jsm, horse",
        "http://h/a%2Fb%3Ac%5Cd.jsm, a_b_c_d",
        "http://h/m/..%2F..%2Fx/manifest.json, .._.._x",
        "http://h/NUL.jsm, _NUL",
        "http://h/a.%20..jsm, a",
        "http://h/, h"
    })
    void shouldSuggestAFileNameThatEverySystemTakes(String address, String name) {
        assertThat(ModelAddress.of(address).fileName()).isEqualTo(name);
    }

    @Test
    void shouldLastWhereverTheProgramIsStarted() {
        Path here = Path.of("").toAbsolutePath();
        assertThat(ModelAddress.of("models/../a.jsm").lasting())
                .isEqualTo(here.resolve("a.jsm").toString());
        assertThat(ModelAddress.of("http://h/a.jsm").lasting()).isEqualTo("http://h/a.jsm");
    }

    @Test
    @Timeout(20)
    @DisabledOnOs(OS.WINDOWS)
    void shouldNotWaitForTheWriterOfAPipe() throws Exception {
        Path pipe = folder.resolve("pipe");
        assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor())
                .isZero();
        assertThat(ModelAddress.ofFile(pipe).kind()).isEqualTo(Kind.MODEL);
    }

    private static String title(String location) {
        return ModelAddress.of(location).title();
    }
}
