package org.jsmesh.desktop;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.Polygon;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;

/** The picture of the program in task bars: a hexagon of triangles that gets finer to the right. */
final class WindowIcon {
    private static final int[] SIDES = {16, 24, 32, 48, 64, 128};
    private static final int[] BLUES = {0x1f5fa8, 0x2b76c8, 0x3f8fe0, 0x5aa5ee, 0x7dbcf6, 0xa4d3fb};

    private WindowIcon() {}

    static List<Image> sizes() {
        List<Image> images = new ArrayList<>();
        for (int side : SIDES) images.add(draw(side));
        return images;
    }

    private static Image draw(int side) {
        BufferedImage image = new BufferedImage(side, side, BufferedImage.TYPE_INT_ARGB);
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        double middle = side / 2.0;
        double radius = side * .48;
        for (int i = 0; i < BLUES.length; i++) {
            Polygon face = new Polygon();
            face.addPoint((int) Math.round(middle), (int) Math.round(middle));
            for (int k = i; k <= i + 1; k++) {
                double angle = Math.PI / 3 * k;
                face.addPoint((int) Math.round(middle + radius * Math.cos(angle)), (int)
                        Math.round(middle + radius * Math.sin(angle)));
            }
            g.setColor(new Color(BLUES[i]));
            g.fillPolygon(face);
        }
        g.dispose();
        return image;
    }
}
