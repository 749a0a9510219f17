package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshComparison;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The tools around a model: each comes when it is used, and does what its button says. */
class PageToolsTest extends PageFixture {
    /** Whether a press in the middle of each button reaches it. */
    private static final String REACHABLE = "[...document.querySelectorAll('.tools button')].every((button) => {"
            + "const { left, top, width, height } = button.getBoundingClientRect();"
            + "return button.contains(document.elementFromPoint(left + width / 2, top + height / 2)); })";

    @Test
    @Tag("long")
    void shouldShowTheSameViewFromALink() {
        openTorus();
        browser.call("const { orbit } = document.getElementById('model').view;"
                + "orbit.turn(1.2, .3); orbit.zoom(.5, .2, .1); orbit.jump();"
                + "const shading = document.getElementById('shading'); shading.value = 'normals';"
                + "shading.dispatchEvent(new Event('change'));");
        List<Double> eye = numbers("eye");
        assertThat(browser.call(
                        "return performance.getEntriesByType('resource').some(r => r.name.includes('/share'));"))
                .isEqualTo(false);
        press("Copy a link to this view");
        browser.await("location.hash.includes('camera=')");
        String link = text("location.href");
        assertThat(link).contains("m=torus", "up=y", "shading=normals").doesNotContain("shading=matte");

        open("m=nothing");
        browser.await("window.jsm?.state === 'error'");
        browser.consoleErrors();
        browser.open(URI.create(link));
        browser.await(
                "window.jsm?.header?.whole && jsm.batches > 0 && document.getElementById('model').view.shading === 'normals'");
        List<Double> after = numbers("eye");
        for (int i = 0; i < 3; i++) assertThat(after.get(i)).isCloseTo(eye.get(i), within(.1));

        for (int[] size : new int[][] {{390, 844}, {844, 390}}) {
            browser.resize(size[0], size[1]);
            browser.await(REACHABLE);
        }
        browser.resize(1000, 700);
        press("Turn by itself");
        browser.await("document.getElementById('model').hasAttribute('auto-rotate')");
        press("Save the picture");
        browser.await("document.querySelector('.said').textContent === 'torus.png saved'");
        assertThat(browser.consoleErrors()).isEmpty();
    }

    @Test
    void shouldLoadOverASlowerLinkAndShowHow() throws IOException {
        openTorus();
        press("Statistics");
        browser.await("document.querySelector('.tool select')");
        browser.call("const limit = document.querySelector('.tool select'); limit.value = '32000';"
                + "limit.dispatchEvent(new Event('change'));"
                + "document.querySelector('.tool .controls > button').click();");
        browser.await("jsm.rounds.length === 2 && jsm.state === 'idle'");
        assertThat(number("jsm.bytesPerSecond")).isBetween(1.0, 40_000.0);
        assertThat(number("jsm.bytes")).isLessThan(.9 * archive.length);
        browser.await("document.querySelector('.tool .facts').textContent.includes('Time to decode')");
        // The whole decoder comes when nobody reads.
        browser.await("document.querySelector('.tool .facts').textContent.includes('WebAssembly')");
        assertThat(browser.text(".tool")).contains("Rounds\n2", "kB/s");
        browser.call(
                "document.activeElement.dispatchEvent(new KeyboardEvent('keydown', { key: 'Escape', bubbles: true }));");
        assertThat(browser.isShown(".tool")).isFalse();
        assertThat(text("document.activeElement.getAttribute('aria-label')")).isEqualTo("Statistics");

        browser.call("document.getElementById('model').session.limit = 0; await jsm.complete();");
        browser.await("document.querySelector('.panel.folded')");
        assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
        assertThat(browser.isShown("#bytes")).isFalse();
        assertThat(MeshComparison.firstDifference(original, downloaded("PLY"))).isEmpty();
        browser.call("document.querySelector('.fold').click();");
        assertThat(browser.isShown("#bytes")).isTrue();
        assertThat(browser.consoleErrors()).isEmpty();
    }

    /** The file that a button of the downloads saves, which has the mesh bit for bit. */
    private Mesh downloaded(String format) throws IOException {
        press("Download");
        browser.await("document.querySelector('.tool .formats')");
        String file = "torus." + format.toLowerCase(Locale.ROOT);
        Object base64 = browser.call(
                "const saved = new Promise((resolve) => { const make = URL.createObjectURL;"
                        + "URL.createObjectURL = (blob) => { resolve(blob); return make.call(URL, blob); }; });"
                        + "[...document.querySelectorAll('.tool .formats button')].find((b) => b.textContent === args[0]).click();"
                        + "const reader = new FileReader(); reader.readAsDataURL(await saved);"
                        + "await new Promise((resolve) => (reader.onload = resolve)); return reader.result.replace(/^.*,/, '');",
                format);
        return ModelFiles.read(
                        Files.write(folder.resolve(file), Base64.getDecoder().decode((String) base64)))
                .mesh();
    }

    private void openTorus() {
        proxy.bytesPerSecond(LINK / 2);
        open("m=torus");
        browser.await("window.jsm?.state === 'idle'");
        browser.await("document.querySelector('.tools')");
        proxy.bytesPerSecond(FAST);
    }

    private void press(String name) {
        browser.click(".tools [aria-label='" + name + "']");
    }

    private List<Double> numbers(String name) {
        Map<?, ?> camera = (Map<?, ?>) browser.call("return jsm.camera;");
        return ((List<?>) camera.get(name))
                .stream().map(v -> ((Number) v).doubleValue()).toList();
    }
}
