package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.net.URI;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Browsers take the graphics card from a page when they need it, and give it back later. Some have none. */
class PageLossTest extends PageFixture {
    /** Of 255 in the mean over all pixels and colours. */
    private static final double NOTHING = .5;

    @Test
    void shouldShowPictureAndLightAgainAfterTheLossOfTheGraphicsCard() {
        browser.open(proxy.through(URI.create("http://127.0.0.1/?m=torus")));
        browser.await("window.jsm?.state === 'idle' || window.jsm?.state === 'complete'");
        browser.call("await jsm.complete();");
        browser.await("document.getElementById('model').view.isWhole");
        BufferedImage before = browser.snapshot(WIDTH, HEIGHT);
        browser.call("""
                const canvas = document.getElementById('model').shadowRoot.querySelector('canvas');
                const loss = canvas.getContext('webgl2').getExtension('WEBGL_lose_context');
                const heard = (name) => new Promise((resolve) => canvas.addEventListener(name, resolve, { once: true }));
                const lost = heard('webglcontextlost');
                loss.loseContext();
                await lost;
                await new Promise((resolve) => setTimeout(resolve));
                const restored = heard('webglcontextrestored');
                loss.restoreContext();
                await restored;
                """);
        BufferedImage after = browser.snapshot(WIDTH, HEIGHT);
        assertThat(covered(before)).isGreaterThan(WIDTH * HEIGHT / 10);
        assertThat(difference(before, after)).isLessThan(NOTHING);
    }

    @Test
    @Tag("long")
    void shouldStopAtWhatTheGraphicsCardHasMemoryForAndSaySo() {
        // No buffer may be larger; that of the indices of the whole model would take 524,160 bytes.
        String scarce = """
                const { prototype } = WebGL2RenderingContext;
                const { bufferData, getError } = prototype;
                let lacks = false;
                prototype.bufferData = function (target, data, ...rest) {
                  if ((data.byteLength ?? data) > 450_000) lacks = true;
                  else bufferData.call(this, target, data, ...rest);
                };
                prototype.getError = function () {
                  const error = lacks ? this.OUT_OF_MEMORY : getError.call(this);
                  lacks = false;
                  return error;
                };
                """;
        browser.before(scarce, () -> {
            proxy.bytesPerSecond(LINK / 4);
            browser.open(proxy.through(URI.create("http://127.0.0.1/m/torus/")));
            browser.await("window.jsm?.state === 'idle' && document.getElementById('model').view.isWhole");
            proxy.bytesPerSecond(FAST);
            browser.click("#original");
            browser.await("jsm.state === 'idle' && jsm.isFull");
            assertThat(number("jsm.faces")).isBetween(5_000., 450_000. / 12);
            browser.await(
                    "document.getElementById('notice').textContent.endsWith('because the graphics card has no memory for more.')");
            assertThat(browser.isShown("#alert")).isFalse();
            assertThat(covered(browser.snapshot(WIDTH, HEIGHT))).isGreaterThan(WIDTH * HEIGHT / 10);
        });
    }

    @Test
    void shouldOfferTheModelWhereNothingCanBeDrawn() {
        browser.before("HTMLCanvasElement.prototype.getContext = () => null;", () -> {
            browser.open(proxy.through(URI.create("http://127.0.0.1/m/torus/")));
            browser.await("document.querySelector('.tool .archive')");
            assertThat(browser.text("#alert-text")).contains("no WebGL 2");
            assertThat(browser.text("#faces")).isEqualTo("0 of 43,680");
            assertThat(browser.isShown("#poster")).isTrue();
            assertThat(text("document.querySelector('.tool .archive').href")).endsWith(".jsm");
            browser.click(".originals button[title='PLY']");
            browser.await("document.querySelector('.originals + p').textContent === 'torus.ply saved.'");
        });
    }

    @Test
    @Tag("long")
    void shouldLeaveNothingOfModelsThatComeAndGo() throws InterruptedException {
        browser.open(proxy.through(URI.create("http://127.0.0.1/m/torus/")));
        browser.await("window.jsm?.state === 'idle' || window.jsm?.state === 'complete'");
        browser.call("""
                window.opened = [];
                const show = async (attributes, isInHaste) => {
                  const viewer = document.createElement('jsm-viewer');
                  for (const [name, value] of Object.entries(attributes)) viewer.setAttribute(name, value);
                  viewer.setAttribute('loading', 'eager');
                  viewer.setAttribute('src', new URL('manifest.json', location.href));
                  viewer.style.cssText = 'position: fixed; width: 200px; height: 150px';
                  document.body.append(viewer);
                  while (!viewer.loaded) await new Promise((resolve) => setTimeout(resolve, 10));
                  const whole = viewer.view.takeOver();
                  if (!isInHaste) await whole;
                  for (const [name, one] of Object.entries({ viewer, view: viewer.view, session: viewer.session }))
                    opened.push({ name: `${name} ${JSON.stringify(attributes)}`, one: new WeakRef(one) });
                  viewer.remove();
                };
                await show({}, true);
                await show({ 'camera-controls': '', 'auto-rotate': '', 'shadow-intensity': 1 });
                await show({ shading: 'normals' });
                await show({ shading: 'matte', wireframe: '' });
                """);
        String left = "return opened.filter(({ one }) => one.deref() !== undefined).map(({ name }) => name);";
        for (int i = 0; i < 50 && !((List<?>) browser.call(left)).isEmpty(); i++) {
            Thread.sleep(200); // what was on its way ends
            browser.collectGarbage();
        }
        assertThat((List<?>) browser.call(left)).isEmpty();
    }

    private static int covered(BufferedImage picture) {
        int count = 0;
        for (int y = 0; y < HEIGHT; y++) for (int x = 0; x < WIDTH; x++) if (picture.getRGB(x, y) >>> 24 != 0) count++;
        return count;
    }

    private static double difference(BufferedImage a, BufferedImage b) {
        long sum = 0;
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++)
                for (int shift = 0; shift < 32; shift += 8)
                    sum += Math.abs((a.getRGB(x, y) >>> shift & 255) - (b.getRGB(x, y) >>> shift & 255));
        return sum / (4.0 * WIDTH * HEIGHT);
    }
}
