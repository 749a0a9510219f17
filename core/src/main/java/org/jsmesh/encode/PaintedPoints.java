package org.jsmesh.encode;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Picture;

/**
 * Points spread evenly over the area of a mesh. Knows the place on the image of each point whose material shows one.
 */
final class PaintedPoints {
    private static final int POINTS = 1 << 17;
    private static final double STEP_1 = 0.7548776662466927; // R2 of Roberts 2018
    private static final double STEP_2 = 0.5698402909980532;
    private static final double LIGHT_GREY = .8;
    private final Mesh mesh;
    private final Channel coordinates;
    private final Map<String, OfTexture> byPath = new HashMap<>();

    /** @param pictures by path of the texture */
    PaintedPoints(Mesh mesh, Map<String, Picture> pictures) {
        this.mesh = mesh;
        Channel uv = mesh.channel(Channel.Semantic.TEXCOORD);
        coordinates = uv == null || uv.components() < 2 ? null : uv;
        if (mesh.textures().isEmpty() || coordinates == null) return;
        OfTexture[] ofMaterial = new OfTexture[mesh.materials().size()];
        for (int i = 0; i < ofMaterial.length; i++) {
            String path = mesh.materials().get(i).displayTexture();
            if (path != null) ofMaterial[i] = byPath.computeIfAbsent(path, p -> new OfTexture(pictures.get(p)));
        }
        spread(ofMaterial);
    }

    /** The points that show a texture, or null when none can. */
    OfTexture of(String path) {
        return byPath.get(path);
    }

    private void spread(OfTexture[] ofMaterial) {
        double[] upTo = new double[mesh.faces()];
        double area = 0;
        for (int f = 0; f < upTo.length; f++) upTo[f] = area += area(f);
        int face = 0;
        for (int i = 0; i < POINTS; i++) {
            double at = (i + .5) / POINTS * area;
            while (face < upTo.length - 1 && upTo[face] <= at) face++;
            int material = mesh.faceMaterials()[face];
            OfTexture texture = material < 0 ? null : ofMaterial[material];
            if (texture == null) continue;
            double u = fraction(i * STEP_1);
            double v = fraction(i * STEP_2);
            if (u + v > 1) {
                u = 1 - u;
                v = 1 - v;
            }
            texture.add(mesh.materials().get(material), mean(face, 0, u, v), mean(face, 1, u, v));
        }
    }

    private double mean(int face, int component, double u, double v) {
        int[] wedges = mesh.faceWedges();
        return (1 - u - v) * coordinates.number(wedges[3 * face], component)
                + u * coordinates.number(wedges[3 * face + 1], component)
                + v * coordinates.number(wedges[3 * face + 2], component);
    }

    private double area(int face) {
        float[] p = mesh.positions();
        int a = 3 * mesh.vertex(face, 0);
        int b = 3 * mesh.vertex(face, 1);
        int c = 3 * mesh.vertex(face, 2);
        double sum = 0;
        for (int k = 0; k < 3; k++) {
            int l = (k + 1) % 3;
            double n = ((double) p[b + k] - p[a + k]) * ((double) p[c + l] - p[a + l])
                    - ((double) p[b + l] - p[a + l]) * ((double) p[c + k] - p[a + k]);
            sum += n * n;
        }
        return Math.sqrt(sum) / 2;
    }

    private static double fraction(double x) {
        return x - Math.floor(x);
    }

    /** The points that show one texture. */
    static final class OfTexture {
        private final Picture picture; // or null
        private int[] pixels = new int[1024]; // of the picture
        private int count;
        private int all;
        private double plainDifference;

        OfTexture(Picture picture) {
            this.picture = picture;
        }

        private void add(Material material, double u, double v) {
            all++;
            if (picture == null || Double.isNaN(u) || Double.isNaN(v)) return;
            // glTF counts v from the top.
            double row = isGltf(material) ? v : 1 - v;
            int x = Math.min(picture.width() - 1, (int) (fraction(u) * picture.width()));
            int y = Math.min(picture.height() - 1, (int) (fraction(row) * picture.height()));
            if (count == pixels.length) pixels = Arrays.copyOf(pixels, 2 * count);
            pixels[count++] = y * picture.width() + x;
            float[] plain = material.displayColour();
            boolean isBlack = plain[0] + plain[1] + plain[2] == 0; // a colour that nobody sees
            int rgb = picture.rgb()[y * picture.width() + x];
            for (int k = 0; k < 3; k++)
                plainDifference += Math.abs((isBlack ? LIGHT_GREY : plain[k]) * 255 - (rgb >> 16 - 8 * k & 255));
        }

        private static boolean isGltf(Material material) {
            List<Material.TextureReference> references = material.textures();
            for (Material.TextureReference r : references) if (r.key().equals("baseColorTexture")) return true;
            return false;
        }

        /** Pixels of the picture in a row. */
        int width() {
            return picture.width();
        }

        int height() {
            return picture.height();
        }

        /** Share of the surface. */
        double share() {
            return (double) all / POINTS;
        }

        /** Difference between the colour of the material and the picture, in % of white over all of the surface. */
        double differenceFromPlain() {
            return percent(plainDifference);
        }

        /** The same for a smaller picture, drawn as it is. */
        double differenceFrom(int[] rgb, int width, int height) {
            double sum = 0;
            for (int i = 0; i < count; i++) {
                int wanted = picture.rgb()[pixels[i]];
                int there = rgb[cell(pixels[i], width, height)];
                for (int shift = 0; shift <= 16; shift += 8)
                    sum += Math.abs((wanted >> shift & 255) - (there >> shift & 255));
            }
            return percent(sum);
        }

        private static double percent(double sum) {
            return 100 * sum / 3 / 255 / POINTS;
        }

        private int cell(int pixel, int width, int height) {
            int x = (int) ((long) (pixel % picture.width()) * width / picture.width());
            int y = (int) ((long) (pixel / picture.width()) * height / picture.height());
            return y * width + x;
        }

        /** Mean colours of the points in the cells of a coarser raster; −1 where there are none. */
        int[] means(int width, int height) {
            long[] sums = new long[3 * width * height];
            int[] counts = new int[width * height];
            for (int i = 0; i < count; i++) {
                int cell = cell(pixels[i], width, height);
                int rgb = picture.rgb()[pixels[i]];
                counts[cell]++;
                for (int k = 0; k < 3; k++) sums[3 * cell + k] += rgb >> 16 - 8 * k & 255;
            }
            int[] means = new int[counts.length];
            for (int c = 0; c < means.length; c++) {
                if (counts[c] == 0) means[c] = -1;
                else
                    for (int k = 0; k < 3; k++)
                        means[c] = means[c] << 8 | (int) ((sums[3 * c + k] + counts[c] / 2) / counts[c]);
            }
            return means;
        }
    }
}
