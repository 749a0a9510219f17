package org.jsmesh.poster;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.display.RenderMesh;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.studio.ContactShadow;
import org.jsmesh.studio.Ground;

/**
 * Draws a mesh on the ground. Each pixel is the mean of some samples. What is seen through nothing comes first: the
 * nearest face of each sample is found, then it gets its light. Translucent faces follow, the farthest first.
 */
final class Painter {
    /** Samples of a pixel, across and down. */
    private static final int SAMPLES = 2;

    /** Samples to look at for all faces. Where they are more, some of the large faces are left out. */
    private static final long MOST_SAMPLES = 1L << 30;

    /** Time for a sample of a face that may be seen through, in that of others. */
    private static final int THROUGH = 4;

    private final int width;
    private final int height;
    private final RenderMesh mesh;
    private final View view;
    private final ContactShadow shadow;
    private final Raster raster;
    private final Fragment fragment;
    private final List<Surface> surfaces = new ArrayList<>();
    private final float[] nearness; // of each sample
    private final int[] faces; // seen in each sample, −1 for none
    private final int[] colours;
    private final long fewSamples; // of a face that is never left out
    private final long every; // of the other faces is drawn
    private boolean isOneSided;

    private Painter(RenderMesh mesh, View view, Images images, int width, int height) {
        this.mesh = mesh;
        this.width = width * SAMPLES;
        this.height = height * SAMPLES;
        float[] placed = view.placed(mesh.positions());
        this.view = view;
        shadow = view.shadow(placed, mesh.indices());
        raster = new Raster(mesh, placed, view, this.width, this.height);
        fragment = new Fragment(mesh, placed, raster, view, SAMPLES);
        for (DisplayMaterial material : mesh.slots().materials()) surfaces.add(new Surface(material, mesh, images));
        nearness = new float[this.width * this.height];
        faces = new int[nearness.length];
        colours = new int[nearness.length];
        Arrays.fill(faces, -1);
        fewSamples = MOST_SAMPLES / Math.max(1, mesh.faces());
        every = 1 + samples() / MOST_SAMPLES;
    }

    private long samples() {
        long samples = 0;
        for (int group = 0; group < surfaces.size(); group++) {
            int from = mesh.groups()[3 * group + 1] / 3;
            int end = from + mesh.groups()[3 * group + 2] / 3;
            int time = surfaces.get(group).isBlended || surfaces.get(group).cutoff > 0 ? THROUGH : 1;
            for (int f = from; f < end; f++) samples += time * raster.samples(f);
        }
        return samples;
    }

    private boolean isLeftOut(int face) {
        return every > 1 && face % every > 0 && raster.samples(face) > fewSamples;
    }

    /**
     * Draws a mesh.
     *
     * @param mesh to draw
     * @param isClosed whether it bounds a solid, so that nobody outside sees a face from behind
     * @param bounds of the model: smallest x, y, z, then largest
     * @param up the axis that points up
     * @param pictures of images, by path
     * @return sRGB of each pixel, red from the third byte on, row by row from the top
     */
    static int[] paint(
            RenderMesh mesh,
            boolean isClosed,
            float[] bounds,
            UpAxis up,
            Map<String, Picture> pictures,
            int width,
            int height) {
        View view = new View(bounds, up, (double) width / height);
        Painter painter = new Painter(mesh, view, new Images(pictures), width, height);
        painter.isOneSided = isClosed && painter.surfaces.stream().allMatch(Surface::isSolid);
        painter.drawGround();
        for (int group = 0; group < painter.surfaces.size(); group++) painter.findNearest(group);
        painter.drawNearest();
        painter.drawTranslucent();
        return painter.pixels();
    }

    private void drawGround() {
        for (int y = 0; y < height; y += SAMPLES) {
            for (int x = 0; x < width; x += SAMPLES) {
                double across = (x + SAMPLES / 2.) / width;
                double down = (y + SAMPLES / 2.) / height;
                double[] ground = Ground.colour(across, down);
                double light = 1 - view.shadowed(shadow, 2 * across - 1, 1 - 2 * down);
                for (int k = 0; k < 3; k++) ground[k] *= light;
                int colour = pixel(ground);
                for (int s = 0; s < SAMPLES * SAMPLES; s++)
                    colours[(y + s / SAMPLES) * width + x + s % SAMPLES] = colour;
            }
        }
    }

    private static int pixel(double[] rgb) {
        return (int) (rgb[0] + .5) << 16 | (int) (rgb[1] + .5) << 8 | (int) (rgb[2] + .5);
    }

    private void findNearest(int group) {
        Surface surface = surfaces.get(group);
        if (surface.isBlended) return;
        int from = mesh.groups()[3 * group + 1] / 3;
        int end = from + mesh.groups()[3 * group + 2] / 3;
        for (int f = from; f < end; f++) {
            if ((isOneSided || !surface.isDoubleSided) && raster.area(f) < 0 || isLeftOut(f)) continue;
            int face = f;
            double[] near = nearness(f);
            raster.visit(f, (sample, a, b, c) -> {
                float here = (float) (a * near[0] + b * near[1] + c * near[2]);
                if (here < nearness[sample]) return;
                if (surface.cutoff > 0) {
                    fragment.of(face, surface);
                    if (!fragment.isThere(a, b, c)) return;
                }
                nearness[sample] = here;
                faces[sample] = face;
            });
        }
    }

    private double[] nearness(int face) {
        double[] near = new double[3];
        for (int k = 0; k < 3; k++) near[k] = raster.nearness(mesh.indices()[3 * face + k]);
        return near;
    }

    private void drawNearest() {
        int[] start = new int[surfaces.size() + 1];
        for (int g = 0; g < surfaces.size(); g++) start[g] = mesh.groups()[3 * g + 1] / 3;
        start[surfaces.size()] = mesh.faces();
        double[] shares = new double[3];
        int group = 0;
        for (int i = 0; i < faces.length; i++) {
            if (faces[i] < 0) continue;
            while (faces[i] < start[group]) group--;
            while (faces[i] >= start[group + 1]) group++;
            fragment.of(faces[i], surfaces.get(group));
            raster.shares(faces[i], i, shares);
            fragment.isThere(shares[0], shares[1], shares[2]);
            fragment.shine();
            colours[i] = pixel(fragment.rgb);
        }
    }

    private void drawTranslucent() {
        List<int[]> blended = new ArrayList<>(); // group, face
        for (int g = 0; g < surfaces.size(); g++) {
            if (!surfaces.get(g).isBlended) continue;
            int from = mesh.groups()[3 * g + 1] / 3;
            int end = from + mesh.groups()[3 * g + 2] / 3;
            for (int f = from; f < end; f++)
                if ((surfaces.get(g).isDoubleSided || raster.area(f) > 0) && !isLeftOut(f))
                    blended.add(new int[] {g, f});
        }
        double[] distance = new double[mesh.faces()];
        for (int[] face : blended) for (double near : nearness(face[1])) distance[face[1]] += near;
        blended.sort((a, b) -> {
            int order = Double.compare(distance[a[1]], distance[b[1]]);
            return order != 0 ? order : Integer.compare(a[1], b[1]);
        });
        for (int[] face : blended) blend(face[1], surfaces.get(face[0]));
    }

    private void blend(int face, Surface surface) {
        double[] near = nearness(face);
        raster.visit(face, (sample, a, b, c) -> {
            if ((float) (a * near[0] + b * near[1] + c * near[2]) < nearness[sample]) return;
            fragment.of(face, surface);
            if (!fragment.isThere(a, b, c)) return;
            fragment.shine();
            for (int k = 0; k < 3; k++) {
                int below = colours[sample] >> 16 - 8 * k & 255;
                fragment.rgb[k] = below + fragment.opacity * (fragment.rgb[k] - below);
            }
            colours[sample] = pixel(fragment.rgb);
        });
    }

    /** Means of the samples of each pixel, as values of the screen, as a browser has them. */
    private int[] pixels() {
        int across = width / SAMPLES;
        int[] pixels = new int[colours.length / (SAMPLES * SAMPLES)];
        int[] sum = new int[3];
        for (int i = 0; i < pixels.length; i++) {
            Arrays.fill(sum, SAMPLES * SAMPLES / 2);
            int corner = (i / across * width + i % across) * SAMPLES;
            for (int s = 0; s < SAMPLES * SAMPLES; s++) {
                int colour = colours[corner + s / SAMPLES * width + s % SAMPLES];
                for (int k = 0; k < 3; k++) sum[k] += colour >> 16 - 8 * k & 255;
            }
            for (int k = 0; k < 3; k++) pixels[i] = pixels[i] << 8 | sum[k] / (SAMPLES * SAMPLES);
        }
        return pixels;
    }
}
