package org.jsmesh.desktop.draw;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.util.BitSet;
import javax.imageio.ImageIO;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.test.picture.PictureComparison;
import org.jsmesh.test.picture.Shading;
import org.jsmesh.test.picture.SoftwareRasteriser;
import org.jsmesh.test.picture.View;

/** Pictures by OpenGL and by the software rasteriser with the same camera and light, and what is expected of them. */
public final class Pictures {
    public static final int WIDTH = 320;
    public static final int HEIGHT = 240;

    /** Cosine of the crease angle of an original. */
    public static final double CREASE = Math.cos(Math.toRadians(42));

    private static final Shading LIGHT = new StudioShading();

    private Pictures() {}

    /** By OpenGL, with the creases of an original. */
    public static BufferedImage drawn(Mesh mesh, float[] bounds, boolean background) {
        return drawn(mesh, CREASE, bounds, background);
    }

    /** By OpenGL. */
    public static BufferedImage drawn(Mesh mesh, double creaseCosine, float[] bounds, boolean background) {
        Framing framing = Framing.of(bounds, UpAxis.UNKNOWN);
        Scene scene = Scene.of(mesh, creaseCosine, false, framing, new TextureImages());
        return Screenshot.take(scene, Camera.framing(framing, WIDTH, HEIGHT), WIDTH, HEIGHT, background);
    }

    /** By other means, with the creases of an original. */
    public static BufferedImage expected(Mesh mesh, float[] bounds) {
        return expected(mesh, CREASE, bounds);
    }

    /** By other means, with the camera's formula written down once more. */
    public static BufferedImage expected(Mesh mesh, double creaseCosine, float[] bounds) {
        View view = View.framing(bounds, 30, 20, 35, .98, (double) WIDTH / HEIGHT);
        return new SoftwareRasteriser(mesh, creaseCosine).draw(view, LIGHT, WIDTH, HEIGHT);
    }

    /**
     * Neither blank nor of one colour; silhouettes agree to 99% (intersection over union).
     *
     * @param tolerance mean difference of the colours over the silhouette, of 255
     */
    public static void assertAgree(BufferedImage drawn, BufferedImage expected, double tolerance) {
        BitSet silhouette = PictureComparison.opaque(drawn);
        assertThat(silhouette.cardinality()).isBetween(WIDTH * HEIGHT / 20, WIDTH * HEIGHT);
        assertThat(PictureComparison.contrast(drawn, silhouette)).isGreaterThan(3);
        assertThat(likeness(drawn, expected)).isGreaterThan(.99);
        silhouette.and(PictureComparison.opaque(expected));
        assertThat(PictureComparison.meanDifference(drawn, expected, silhouette))
                .isLessThan(tolerance);
    }

    /** Intersection over union of the silhouettes. */
    public static double likeness(BufferedImage a, BufferedImage b) {
        return PictureComparison.intersectionOverUnion(PictureComparison.opaque(a), PictureComparison.opaque(b));
    }

    /** Leaves the picture for people to look at. */
    public static void keep(String name, BufferedImage picture) throws IOException {
        File folder = new File("target/pictures");
        folder.mkdirs();
        ImageIO.write(picture, "png", new File(folder, name + ".png"));
    }
}
