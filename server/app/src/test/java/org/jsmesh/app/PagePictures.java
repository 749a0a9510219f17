package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.BitSet;
import javax.imageio.ImageIO;
import org.jsmesh.test.picture.PictureComparison;

/** Keeps pictures for people to look at, and compares them. */
final class PagePictures {
    private static final Path KEPT = Path.of("target", "pictures");

    private PagePictures() {}

    static void keep(String name, BufferedImage picture) throws IOException {
        Files.createDirectories(KEPT);
        ImageIO.write(picture, "png", KEPT.resolve(name + ".png").toFile());
    }

    /** Pictures in a row, on grey. */
    static BufferedImage beside(BufferedImage... pictures) {
        int width = pictures[0].getWidth();
        BufferedImage row =
                new BufferedImage(width * pictures.length, pictures[0].getHeight(), BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = row.createGraphics();
        graphics.setColor(Color.GRAY);
        graphics.fillRect(0, 0, row.getWidth(), row.getHeight());
        for (int i = 0; i < pictures.length; i++) graphics.drawImage(pictures[i], i * width, 0, null);
        graphics.dispose();
        return row;
    }

    /** Neither is blank, the silhouettes agree, and so do the colours where both have one. */
    static void assertAgree(BufferedImage drawn, BufferedImage expected, double overlap, double tolerance) {
        BitSet mask = PictureComparison.opaque(drawn);
        BitSet expectedMask = PictureComparison.opaque(expected);
        int pixels = drawn.getWidth() * drawn.getHeight();
        assertThat(mask.cardinality()).as("pixels drawn").isBetween(pixels / 20, pixels * 9 / 10);
        assertThat(PictureComparison.contrast(drawn, mask)).as("contrast").isGreaterThan(8);
        assertThat(PictureComparison.intersectionOverUnion(mask, expectedMask))
                .as("overlap of the silhouettes")
                .isGreaterThanOrEqualTo(overlap);
        mask.and(expectedMask);
        assertThat(PictureComparison.meanDifference(drawn, expected, mask))
                .as("mean difference of the colours")
                .isLessThanOrEqualTo(tolerance);
    }
}
