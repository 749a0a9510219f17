package org.jsmesh.app.bench;

import java.io.IOException;
import java.util.HashSet;
import java.util.Set;
import org.jsmesh.display.CreaseAngle;
import org.jsmesh.encode.measure.SurfaceProbe;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.Texture;

/**
 * Measures how much the shown surface differs from the original for the eye. At points spread over the original's
 * surface it compares position, normal, colour, and the light that the surface throws back to six viewers who look
 * along the axes and bring their own lamps. Deterministic.
 */
public final class PictureMeter {
    private static final int SAMPLES = 20_000;

    private final SurfaceProbe probe;
    private final ImageSamples images;
    private final int baseFaces;
    private final int faces;
    private final double diagonal;
    private final double[] normals = new double[3 * SAMPLES];
    private final double[] colours = new double[3 * SAMPLES];
    private final double[] emissions = new double[3 * SAMPLES];
    private final double[] surfaces = new double[SurfaceLook.SURFACE_VALUES * SAMPLES];

    /**
     * How far off a level of detail is on average.
     *
     * @param distance to the nearest point shown, in % of the bounding box's diagonal
     * @param normal angle between the normals, in degrees
     * @param colour difference of red, green and blue, and of light that the surface sends out, in % of their range
     * @param surface effect of other images that have not arrived (normals, metal, roughness, occlusion, opacity), in %
     *     of the light from a white surface
     * @param picture difference of the light thrown back and sent out, with that effect, in % of the light from a white
     *     surface
     */
    public record Difference(double distance, double normal, double colour, double surface, double picture) {}

    /** @param baseFaces of the coarsest mesh shown; the page's crease angle depends on it */
    PictureMeter(Mesh original, int baseFaces) throws IOException {
        this.baseFaces = baseFaces;
        faces = original.faces();
        probe = new SurfaceProbe(original, SAMPLES);
        images = new ImageSamples(original.textures());
        float[] b = original.bounds();
        diagonal = Math.sqrt(square(b[3] - b[0]) + square(b[4] - b[1]) + square(b[5] - b[2]));
        SurfaceLook look = look(original);
        double[] value = new double[3];
        double[] surface = new double[SurfaceLook.SURFACE_VALUES];
        for (int i = 0; i < SAMPLES; i++) {
            look.normal(probe.original(), i, value);
            System.arraycopy(value, 0, normals, 3 * i, 3);
            look.colour(probe.original(), i, value);
            System.arraycopy(value, 0, colours, 3 * i, 3);
            look.emission(probe.original(), i, value);
            System.arraycopy(value, 0, emissions, 3 * i, 3);
            look.surface(probe.original(), i, surface);
            System.arraycopy(surface, 0, surfaces, surface.length * i, surface.length);
        }
    }

    private SurfaceLook look(Mesh mesh) {
        Set<String> shown = new HashSet<>();
        for (Texture t : mesh.textures()) shown.add(t.path());
        for (Picture p : mesh.previews()) shown.add(p.path());
        double crease = CreaseAngle.cosine(mesh.faces(), baseFaces, faces);
        return new SurfaceLook(mesh, crease, images.with(mesh.previews()), shown);
    }

    /** @param level with at least one face */
    Difference measure(Mesh level) {
        SurfaceProbe.Places places = probe.on(level);
        SurfaceLook look = look(level);
        double[] normal = new double[3];
        double[] colour = new double[3];
        double distance = 0;
        double angle = 0;
        double[] sent = new double[3];
        double[] surface = new double[SurfaceLook.SURFACE_VALUES];
        double paint = 0;
        double glow = 0;
        double other = 0;
        double light = 0;
        double white = 0;
        for (int i = 0; i < SAMPLES; i++) {
            look.normal(places, i, normal);
            look.colour(places, i, colour);
            look.emission(places, i, sent);
            look.surface(places, i, surface);
            other += difference(surface, surfaces, i);
            glow += difference(sent, emissions, i) / 3;
            distance += places.distances()[i];
            double dot = 0;
            for (int k = 0; k < 3; k++) dot += normal[k] * normals[3 * i + k];
            angle += Math.toDegrees(Math.acos(Math.max(-1, Math.min(1, dot))));
            paint += difference(colour, colours, i) / 3;
            for (int view = 0; view < 6; view++) {
                int sign = view < 3 ? 1 : -1;
                double wanted = Math.max(0, sign * normals[3 * i + view % 3]);
                double there = Math.max(0, sign * normal[view % 3]);
                white += wanted;
                for (int k = 0; k < 3; k++) light += Math.abs(there * colour[k] - wanted * colours[3 * i + k]) / 3;
            }
        }
        return new Difference(
                diagonal > 0 ? 100 * distance / SAMPLES / diagonal : 0,
                angle / SAMPLES,
                100 * (paint + glow) / SAMPLES,
                100 * other / SAMPLES,
                100 * (light / white + (glow + other) / SAMPLES));
    }

    private static double difference(double[] there, double[] wanted, int sample) {
        double sum = 0;
        for (int k = 0; k < there.length; k++) sum += Math.abs(there[k] - wanted[there.length * sample + k]);
        return sum;
    }

    private static double square(double x) {
        return x * x;
    }
}
