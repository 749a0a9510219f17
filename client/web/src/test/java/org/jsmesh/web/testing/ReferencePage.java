package org.jsmesh.web.testing;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import org.jsmesh.test.picture.View;

/**
 * Draws GLB files in a browser by three's own {@code GLTFLoader}, under the same light, environment and tone mapping as
 * the page in its smooth shading. Not thread-safe.
 */
public final class ReferencePage implements AutoCloseable {
    /** The loader takes images out of a file by addresses of blobs. */
    private static final String POLICY = "default-src 'self' blob: data:";

    private final PageServer server = new PageServer(POLICY);
    private final Browser browser;

    /** Opens the page in a browser, which must not leave it as long as it is drawn with. */
    public ReferencePage(Browser browser) throws IOException {
        this.browser = browser;
        for (String file : new String[] {"/reference.html", "/reference.js"}) {
            try (InputStream in = ReferencePage.class.getResourceAsStream(file.substring(1))) {
                server.put(file, in.readAllBytes());
            }
        }
        browser.open(server.address("/reference.html"));
        browser.await("window.draw !== undefined");
    }

    /** The picture on a transparent background. */
    public BufferedImage draw(byte[] glb, View view, int width, int height) {
        Map<String, ?> camera = Map.of(
                "eye", numbers(view.eye()),
                "target", numbers(view.target()),
                "up", numbers(view.up()),
                "fieldOfView", view.fieldOfView());
        return Browser.picture((String) browser.call(
                "return draw(args[0], args[1], args[2], args[3]);",
                Base64.getEncoder().encodeToString(glb),
                camera,
                width,
                height));
    }

    private static List<Double> numbers(double[] values) {
        return Arrays.stream(values).boxed().toList();
    }

    @Override
    public void close() {
        server.close();
    }
}
