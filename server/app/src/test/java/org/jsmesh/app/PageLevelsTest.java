package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.Arrays;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.TriangleDistance;
import org.junit.jupiter.api.Test;

/** What the page shows of a model's levels: one, two side by side, and how far one is from the original. */
class PageLevelsTest extends PageFixture {
    private static final String SHOWN = "document.querySelector('.levels output')?.textContent";
    private static final String LEGEND = "document.querySelector('.levels [data-most]')?.dataset";

    @Test
    void shouldShowAnyLevelThatHasArrivedWhileOthersArrive() throws IOException {
        proxy.bytesPerSecond(LINK);
        openTool();
        int some = 3;
        show(some);
        String facesAndBytes = text(SHOWN + ".split(':')[1]");
        proxy.bytesPerSecond(FAST);
        browser.call("await jsm.complete();");
        browser.await("jsm.state === 'complete'");
        assertThat(text(SHOWN + ".split(':')[1]")).isEqualTo(facesAndBytes);
        int middle = (int) number("jsm.header.ends.length") / 2;
        show(middle);
        assertThatPictureAgrees("levels-middle", meshAfter(middle), COLOUR_TOLERANCE);
        show((int) number("jsm.batches"));
        browser.click(".tool header button");
        browser.await("document.querySelector('.levels') === null");
        assertThatPictureAgrees("levels-closed", original, COLOUR_TOLERANCE);
        assertThat(browser.consoleErrors()).isEmpty();
    }

    @Test
    void shouldCompareTwoLevelsAndMeasureOne() throws IOException {
        openTool();
        browser.call("await jsm.complete();");
        browser.await("jsm.state === 'complete'");
        BufferedImage newest = browser.snapshot(WIDTH, HEIGHT);
        show(2);
        BufferedImage coarse = browser.snapshot(WIDTH, HEIGHT);
        browser.click(".levels input[type=checkbox]");
        browser.await("document.querySelector('.comparison .right').textContent.includes('43,680 faces')");
        BufferedImage both = browser.snapshot(WIDTH, HEIGHT);
        PagePictures.keep("levels-compared", both);
        assertThat(part(both, 0, WIDTH / 2)).isEqualTo(part(coarse, 0, WIDTH / 2));
        assertThat(part(both, WIDTH / 2, WIDTH)).isEqualTo(part(newest, WIDTH / 2, WIDTH));
        assertThat(part(coarse, WIDTH / 2, WIDTH)).isNotEqualTo(part(newest, WIDTH / 2, WIDTH));

        browser.call("const divider = document.querySelector('.comparison .divider'); divider.focus();"
                + "divider.dispatchEvent(new KeyboardEvent('keydown', { key: 'Home' }));"
                + "divider.dispatchEvent(new KeyboardEvent('keydown', { key: 'PageUp' }));");
        assertThat(text("document.querySelector('.comparison .divider').getAttribute('aria-valuenow')"))
                .isEqualTo("12");
        browser.click(".levels input[type=checkbox]");

        BufferedImage plain = browser.snapshot(WIDTH, HEIGHT);
        paint("levels");
        browser.await("document.querySelector('.levels .ends').textContent.startsWith('Base')");
        paint("distance");
        browser.await(LEGEND + "?.most");
        BufferedImage painted = browser.snapshot(WIDTH, HEIGHT);
        PagePictures.keep("levels-distance", painted);
        assertThat(part(painted, 0, WIDTH)).isNotEqualTo(part(plain, 0, WIDTH));
        double most = number("Number(" + LEGEND + ".most)");
        double[] at = Arrays.stream(text(LEGEND + ".at").split(","))
                .mapToDouble(Double::parseDouble)
                .toArray();
        assertThat(most).isGreaterThan(0);
        assertThat(distance(at)).isCloseTo(most, within(1e-6));
        for (double[] middle : middles(meshAfter(2)))
            assertThat(distance(middle)).isLessThanOrEqualTo(most * 1.05);
        assertThat(browser.consoleErrors()).isEmpty();
    }

    private void openTool() {
        open("m=torus");
        browser.await("window.jsm?.state === 'idle' || window.jsm?.state === 'complete'");
        browser.await("document.querySelector('[aria-label=\"Levels of detail\"]') !== null");
        browser.click("[aria-label='Levels of detail']");
        browser.await(SHOWN);
    }

    /** Chooses a level, and waits until it is shown: with as many faces as the index says. */
    private void show(int batches) {
        browser.call(
                "const slider = document.querySelector('.levels input[type=range]'); slider.value = args[0];"
                        + "slider.dispatchEvent(new Event('input'));",
                batches);
        String faces = "jsm.header.batchFaces[" + (batches - 1) + "].toLocaleString('en')";
        String level = "jsm.header.batchLevels[" + (batches - 1) + "]";
        browser.await(SHOWN + ".startsWith(`Level ${" + level + "} of `) && " + SHOWN + ".includes(`: ${" + faces
                + "} faces, `)");
    }

    private void paint(String paint) {
        browser.call(
                "const colours = document.querySelector('.levels select'); colours.value = args[0];"
                        + "colours.dispatchEvent(new Event('change'));",
                paint);
    }

    private Mesh meshAfter(int batches) throws IOException {
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(archive, 0, (int) number("jsm.header.ends[" + (batches - 1) + "]"));
        assertThat(decoder.batches()).isEqualTo(batches);
        return decoder.mesh();
    }

    private static int[] part(BufferedImage picture, int from, int to) {
        return picture.getRGB(from, 0, to - from, picture.getHeight(), null, 0, to - from);
    }

    /** From a point to the original, each of whose triangles is looked at. */
    private double distance(double[] point) {
        double least = Double.POSITIVE_INFINITY;
        for (int f = 0; f < original.faces(); f++) {
            double squared = TriangleDistance.squared(
                    original.positions(),
                    corner(original, f, 0),
                    corner(original, f, 1),
                    corner(original, f, 2),
                    point[0],
                    point[1],
                    point[2]);
            least = Math.min(least, squared);
        }
        return Math.sqrt(least);
    }

    private static int corner(Mesh mesh, int face, int corner) {
        return 3 * mesh.wedgeVertices()[mesh.faceWedges()[3 * face + corner]];
    }

    private static double[][] middles(Mesh mesh) {
        double[][] middles = new double[mesh.faces()][3];
        for (int f = 0; f < mesh.faces(); f++)
            for (int k = 0; k < 9; k++) middles[f][k % 3] += mesh.positions()[corner(mesh, f, k / 3) + k % 3] / 3;
        return middles;
    }
}
