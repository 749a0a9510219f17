package org.jsmesh.desktop.launch;

import java.awt.AWTException;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.image.BufferedImage;
import java.io.IOException;
import org.jsmesh.desktop.draw.Pictures;

/** What is on the screen, whoever draws there. */
final class Screen {
    private static final int HUES = 6;
    private static final int PIXELS_EACH = 1000;
    private static final int VIVID = 80;

    private Screen() {}

    private static BufferedImage picture() {
        try {
            return new Robot()
                    .createScreenCapture(
                            new Rectangle(Toolkit.getDefaultToolkit().getScreenSize()));
        } catch (AWTException e) {
            throw new IllegalStateException(e);
        }
    }

    /**
     * Whether vivid colours all around the circle of hues are there, as the painted torus has them and no window does.
     */
    static boolean showsManyColours() {
        BufferedImage picture = picture();
        int[] counts = new int[HUES];
        for (int y = 0; y < picture.getHeight(); y++) {
            for (int x = 0; x < picture.getWidth(); x++) {
                int rgb = picture.getRGB(x, y);
                int r = rgb >> 16 & 255;
                int g = rgb >> 8 & 255;
                int b = rgb & 255;
                int most = Math.max(r, Math.max(g, b));
                if (most - Math.min(r, Math.min(g, b)) < VIVID) continue;
                counts[hue(r, g, b, most)]++;
            }
        }
        int seen = 0;
        for (int count : counts) if (count >= PIXELS_EACH) seen++;
        return seen >= HUES / 2;
    }

    /** A sixth of the circle: by the strongest and the weakest of the three. */
    private static int hue(int r, int g, int b, int most) {
        if (most == r) return g >= b ? 0 : 5;
        if (most == g) return b >= r ? 2 : 1;
        return r >= g ? 4 : 3;
    }

    static void keep(String name) throws IOException {
        Pictures.keep(name, picture());
    }
}
