package org.jsmesh.test.picture;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.display.Slot;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.Texture;

/**
 * The colour of a point of a face in linear light: material colour × vertex colour × texture. A texture that is there
 * hides the colour of an MTL material below it.
 */
final class Albedo {
    private final Mesh mesh;
    private final Channel colour;
    private final Channel uv;
    private final Map<String, BufferedImage> images = new HashMap<>();

    Albedo(Mesh mesh) {
        this.mesh = mesh;
        colour = mesh.channel(Channel.Semantic.COLOUR);
        uv = mesh.channel(Channel.Semantic.TEXCOORD);
        for (Texture t : mesh.textures()) images.put(t.path(), image(t.bytes()));
        for (Picture preview : mesh.previews()) images.put(preview.path(), image(preview));
    }

    private static BufferedImage image(Picture p) {
        BufferedImage image = new BufferedImage(p.width(), p.height(), BufferedImage.TYPE_INT_ARGB);
        image.setRGB(0, 0, p.width(), p.height(), p.argb(), 0, p.width());
        return image;
    }

    private static BufferedImage image(byte[] file) {
        try {
            return ImageIO.read(new ByteArrayInputStream(file));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * @param weights of the three corners, perspective-correct, sum 1
     * @param uncoloured sRGB of a face that nothing colours
     */
    double[] at(int face, double[] weights, double[] uncoloured) {
        int id = mesh.faceMaterials()[face];
        Material material = id < 0 ? null : mesh.materials().get(id);
        BufferedImage image = material == null || uv == null
                ? null
                : images.get(look(material).image(Slot.COLOUR));
        double[] albedo = ofMaterial(material, image != null, uncoloured);
        if (colour != null) multiply(albedo, ofVertices(face, weights));
        if (image != null) multiply(albedo, ofTexture(face, weights, image, material));
        return albedo;
    }

    private double[] ofMaterial(Material material, boolean textured, double[] uncoloured) {
        DisplayMaterial look = look(material);
        List<Float> given = look.colour(textured);
        double[] albedo = new double[3];
        for (int k = 0; k < 3; k++) {
            double c = given == null ? uncoloured[k] : given.get(k);
            albedo[k] = look.linear() ? c : linear(c);
        }
        return albedo;
    }

    private DisplayMaterial look(Material material) {
        return DisplayMaterial.of(material, colour != null);
    }

    private double[] ofVertices(int face, double[] weights) {
        double[] sum = new double[3];
        for (int corner = 0; corner < 3; corner++) {
            int wedge = mesh.faceWedges()[3 * face + corner];
            for (int k = 0; k < 3; k++) {
                sum[k] += weights[corner] * (colour.isAbsent(wedge) ? 1 : linear(colour.number(wedge, k)));
            }
        }
        return sum;
    }

    private double[] ofTexture(int face, double[] weights, BufferedImage image, Material material) {
        double u = 0;
        double v = 0;
        for (int corner = 0; corner < 3; corner++) {
            int wedge = mesh.faceWedges()[3 * face + corner];
            u += weights[corner] * uv.number(wedge, 0);
            v += weights[corner] * uv.number(wedge, 1);
        }
        boolean fromTop = material.isGltf();
        return bilinear(image, u * image.getWidth() - .5, (fromTop ? v : 1 - v) * image.getHeight() - .5);
    }

    private static double[] bilinear(BufferedImage image, double x, double y) {
        int x0 = (int) Math.floor(x);
        int y0 = (int) Math.floor(y);
        double[] sum = new double[3];
        for (int dy = 0; dy < 2; dy++) {
            for (int dx = 0; dx < 2; dx++) {
                double weight = (dx == 0 ? 1 - (x - x0) : x - x0) * (dy == 0 ? 1 - (y - y0) : y - y0);
                int rgb = image.getRGB(
                        Math.floorMod(x0 + dx, image.getWidth()), Math.floorMod(y0 + dy, image.getHeight()));
                for (int k = 0; k < 3; k++) sum[k] += weight * linear((rgb >> 16 - 8 * k & 255) / 255.0);
            }
        }
        return sum;
    }

    private static void multiply(double[] a, double[] b) {
        for (int k = 0; k < 3; k++) a[k] *= b[k];
    }

    static double linear(double srgb) {
        return srgb <= .04045 ? srgb / 12.92 : Math.pow((srgb + .055) / 1.055, 2.4);
    }

    static double srgb(double linear) {
        double l = Math.max(0, Math.min(1, linear));
        return l <= .0031308 ? 12.92 * l : 1.055 * Math.pow(l, 1 / 2.4) - .055;
    }
}
