package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What those need of the page who study models: to find one among many, and to look into it. */
class PageStudyTest extends PageFixture {
    private static final int MANY = 301;
    private static final String NAMES =
            "[...document.querySelectorAll('.card strong')].map((name) => name.textContent).join()";

    private static final String LENGTH_IS_SEEN = "(() => {"
            + "const length = document.querySelector('.marks span.length').getBoundingClientRect();"
            + "const picture = document.getElementById('model').getBoundingClientRect();"
            + "return picture.width === innerWidth && length.width > 0 && length.left > 0 && length.right < picture.right"
            + " && length.top > 0 && length.bottom < picture.bottom; })()";

    @Test
    void shouldFindAModelAmongManyAndComeBackToIt() throws IOException {
        Path models = folder.resolve("models");
        Path first = Files.write(models.resolve("Große Vase 1000.jsm"), archive);
        for (int i = 1; i < MANY - 1; i++) Files.createLink(models.resolve("Pot " + i + ".jsm"), first);
        // Otherwise the watch may know some of them only; the list does not follow those that come while it is shown.
        assertThat(store.list()).hasSize(MANY);
        open("");
        browser.await("document.querySelectorAll('.card').length > 8");
        assertThat(number("document.querySelectorAll('.card').length")).isLessThan(40);
        browser.await("document.querySelector('.browse p').textContent === '301 models'");

        browser.call("document.querySelectorAll('.card')[3].focus();"
                + "scrollTo(0, document.documentElement.scrollHeight);");
        browser.await("document.querySelector(\"[aria-posinset='301'][aria-setsize='301']\")");
        assertThat(number("document.querySelectorAll('.card').length")).isLessThan(40);
        assertThat(text("document.activeElement.querySelector('strong').textContent"))
                .isEqualTo("Pot 3");

        browser.call("const box = document.querySelector('.browse input'); box.value = 'grosse VASE';"
                + "box.dispatchEvent(new Event('input'));");
        browser.await("document.querySelector('.browse p').textContent === '1 of 301 models'");
        assertThat(text(NAMES)).isEqualTo("Große Vase 1000");
        assertThat(text("location.search")).isEqualTo("?q=grosse+VASE");

        browser.call("const box = document.querySelector('.browse input'); box.value = 'pot';"
                + "box.dispatchEvent(new Event('input')); const sorting = document.querySelector('.browse select');"
                + "sorting.value = 'size'; sorting.dispatchEvent(new Event('input')); scrollTo(0, 3000);");
        browser.await("location.search === '?q=pot&sort=size' && document.querySelector('.cards li').offsetTop > 1000");
        String seen = text(NAMES);
        browser.call("document.querySelectorAll('.card')[9].click();");
        browser.await("window.jsm?.batches > 0");
        browser.call("history.back();");
        browser.await("document.querySelectorAll('.card').length > 8");
        assertThat(text(NAMES)).isEqualTo(seen);
        assertThat(number("scrollY")).isEqualTo(3000);
        assertThat(browser.consoleErrors()).isEmpty();
    }

    @Test
    void shouldMeasureCutAndAnnotateAndPutAllIntoALink() throws IOException {
        Path models = folder.resolve("models");
        Files.writeString(
                models.resolve("torus.annotations.json"),
                "{\"annotations\": [{\"title\": \"<b>Rim</b>\", \"text\": \"Outside\", \"point\": [0, 0, 1.3],"
                        + "\"camera\": {\"eye\": [0, 0, 9], \"target\": [0, 0, 0]}}, {\"title\": \"\"}]}");
        open("m=torus");
        browser.await("window.jsm?.state === 'idle' || window.jsm?.state === 'complete'");
        browser.call("await jsm.complete();");
        browser.await("document.querySelector('.marks .note')");
        browser.call("document.querySelector('.marks .note').click();");
        browser.await("document.querySelector('.tool .notes p')?.textContent === 'Outside'"
                + " && Math.abs(jsm.camera.eye[0]) < .01 && Math.abs(jsm.camera.eye[2] - 9) < .01");
        assertThat(browser.text(".tool .notes li button")).isEqualTo("<b>Rim</b>");
        assertThat(browser.text(".tool .problems")).contains("Annotation 2 is left out");
        writeChangeAndRemoveOnesOwn();

        press("Measure");
        browser.await("document.querySelector('.tool .measured')");
        click(.5, "1");
        browser.await("document.querySelector('.tool p').textContent.startsWith('Now the second')");
        click(-.5, "1");
        browser.await("document.querySelector('.marks span.length')");
        assertThat(browser.text(".tool .measured li span")).matches("\\d[\\d.]* units?");
        String measured = browser.text(".tool .measured li span");

        int before = drawnPixels();
        press("Cut open");
        browser.await("document.querySelector('.tool .section') && document.getElementById('model').view.stage?.cut");
        int cut = drawnPixels();
        assertThat(cut).isLessThan(before * 3 / 4);
        assertThat(insidePixels()).as("the inside of a solid is seen").isGreaterThan(200);
        press("Copy a link to this view");
        browser.await("location.hash.includes('cut=x,0.5')");
        String link = text("location.href");
        assertThat(link).contains("measure=", "camera=", "notes=");
        browser.call("document.querySelectorAll('.tool .pair button')[1].click();");
        assertThat(drawnPixels()).isEqualTo(before);

        open("m=nothing");
        browser.await("window.jsm?.state === 'error'");
        browser.consoleErrors();
        browser.open(URI.create(link + "&lod=2,newest"));
        browser.await("document.querySelector('.marks span.length') && document.querySelector('.tool .levels')"
                + " && document.getElementById('model').view.stage?.cut && document.querySelector('.marks .note')");
        assertThat(browser.text(".marks span.length")).isEqualTo(measured);
        browser.await("document.querySelector('.levels input').value === '2'");
        browser.await("document.querySelector('.comparison .right').textContent.includes('43,680 faces')");
        assertThat(browser.text(".marks .note:last-of-type")).isEqualTo("2");
        for (int[] size : new int[][] {{390, 844}, {1000, 700}}) {
            browser.resize(size[0], size[1]);
            browser.await(LENGTH_IS_SEEN);
        }
        press("Copy a link to this view");
        browser.await("location.hash.includes('lod=2,newest')");
        assertThat(browser.consoleErrors()).isEmpty();
    }

    /** One stays, which has other words, another place and another camera than at first. */
    private void writeChangeAndRemoveOnesOwn() {
        for (String title : new String[] {"Wrong", "Superfluous"}) {
            pressNamed("Write one");
            pressNamed("Take the middle of the picture");
            write(title, "");
            pressNamed("Add");
        }
        browser.call("document.querySelectorAll('.tool .notes [aria-expanded]')[2]"
                + ".dispatchEvent(new KeyboardEvent('keydown', { key: 'Delete', bubbles: true }));");
        assertThat(text("document.activeElement.textContent")).isEqualTo("Wrong");
        String mark = "document.querySelectorAll('.marks .note')[1]";
        browser.call("document.activeElement.click();");
        String before = text(mark + ".style.transform");
        pressNamed("Edit");
        browser.call("const { orbit } = document.getElementById('model').view; orbit.turn(.3, 0); orbit.jump();");
        pressNamed("See it from here");
        pressNamed("Move it");
        pressNamed("Take the middle of the picture");
        browser.await("document.querySelector('.tool .form textarea')");
        write("Right", "Some words");
        pressNamed("Save");
        assertThat(text("document.activeElement.textContent")).isEqualTo("Right");
        assertThat(browser.text(".tool .notes p")).isEqualTo("Some words");
        assertThat(text(mark + ".title")).isEqualTo("Right");
        pressNamed("Edit");
        write("Nothing of this", "");
        browser.call("document.activeElement.dispatchEvent("
                + "new KeyboardEvent('keydown', { key: 'Escape', bubbles: true }));");
        assertThat(browser.text(".tool .notes")).contains("Right").doesNotContain("Nothing", "Wrong", "Superfluous");
        browser.call("const { orbit } = document.getElementById('model').view; orbit.turn(-.3, 0); orbit.jump();");
        assertThat(text(mark + ".style.transform")).isNotEqualTo(before);
    }

    private void write(String title, String text) {
        browser.await("document.querySelector('.tool .form input')");
        browser.call(
                "document.querySelector('.tool .form input').value = args[0];"
                        + "document.querySelector('.tool .form textarea').value = args[1];",
                title,
                text);
    }

    /** A button of the controls, by what stands on it. */
    private void pressNamed(String name) {
        browser.call(
                "[...document.querySelectorAll('.tool .controls button')].find((b) => b.textContent === args[0]).click();",
                name);
    }

    /** A click at a place of the model. */
    private void click(double x, String z) {
        browser.call("const { orbit, size } = document.getElementById('model').view;"
                + "const viewer = document.getElementById('model'); const { left, top } = viewer.getBoundingClientRect();"
                + "const { eye, fieldOfView, aspect, shift } = orbit.camera;"
                + "const slope = 1 / Math.tan(fieldOfView * Math.PI / 360) / (eye[2] - " + z + ");"
                + "const at = { bubbles: true, composed: true, clientX: left + (1 + slope * (" + x
                + " - eye[0]) / aspect) * size.width / 2, clientY: top + (1 - shift) * size.height / 2 };"
                + "const stage = viewer.shadowRoot.querySelector('.stage');"
                + "viewer.dispatchEvent(new PointerEvent('pointerdown', at)); "
                + "stage.dispatchEvent(new MouseEvent('click', at));");
    }

    private int drawnPixels() throws IOException {
        BufferedImage picture = browser.snapshot(WIDTH, HEIGHT);
        int drawn = 0;
        for (int y = 0; y < HEIGHT; y++) for (int x = 0; x < WIDTH; x++) if (picture.getRGB(x, y) >>> 24 > 128) drawn++;
        return drawn;
    }

    /** From both sides of the cut, pixels in the tone of what is seen from behind. */
    private int insidePixels() throws IOException {
        int inside = 0;
        browser.call("const { orbit } = document.getElementById('model').view; window.pose = orbit.pose;");
        for (String way : List.of("1", "-1")) {
            browser.call("const { orbit } = document.getElementById('model').view; orbit.moveTo(window.pose);"
                    + "orbit.turn(" + way + ", 0); orbit.jump();");
            BufferedImage picture = browser.snapshot(WIDTH, HEIGHT);
            for (int i = 0; i < WIDTH * HEIGHT; i++) if (picture.getRGB(i % WIDTH, i / WIDTH) == 0xff0f766e) inside++;
        }
        browser.call(
                "const { orbit } = document.getElementById('model').view; orbit.moveTo(window.pose); orbit.jump();");
        return inside;
    }

    private void press(String name) {
        browser.click(".tools [aria-label='" + name + "']");
    }
}
