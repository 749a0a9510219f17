package org.jsmesh.test.picture;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;

/**
 * Draws a mesh with nothing but arithmetic in double: edge functions (Pineda 1988), a depth buffer, perspective-correct
 * interpolation, light per sample. Both sides of a face are lit. Slow and plain on purpose: it is the other means that
 * the viewers' pictures are compared with. A face that reaches behind the eye is not drawn; translucent materials are
 * drawn opaque.
 */
public final class SoftwareRasteriser {
    private static final int SAMPLES = 2;

    private final Mesh mesh;
    private final Albedo albedo;
    private final double[][] normals;

    /** Without normals in the file all faces around a vertex are smoothed. */
    public SoftwareRasteriser(Mesh mesh) {
        this(mesh, -2);
    }

    /** @param creaseCosine cosine of the angle above which faces around a vertex are not smoothed with one another */
    public SoftwareRasteriser(Mesh mesh, double creaseCosine) {
        this.mesh = mesh;
        albedo = new Albedo(mesh);
        normals = cornerNormals(mesh, creaseCosine);
    }

    /** A picture with transparent surroundings; 2 × 2 samples per pixel. */
    public BufferedImage draw(View view, Shading light, int width, int height) {
        Canvas canvas = new Canvas(view, light, width * SAMPLES, height * SAMPLES);
        for (int f = 0; f < mesh.faces(); f++) canvas.draw(f);
        BufferedImage picture = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) picture.setRGB(x, y, canvas.pixel(x, y));
        }
        return picture;
    }

    private static double[][] cornerNormals(Mesh mesh, double creaseCosine) {
        double[][] ofFaces = new double[mesh.faces()][];
        List<List<double[]>> around = new ArrayList<>();
        for (int v = 0; v < mesh.vertices(); v++) around.add(new ArrayList<>());
        for (int f = 0; f < mesh.faces(); f++) {
            double[] a = position(mesh, mesh.vertex(f, 0));
            ofFaces[f] = Vectors.cross(
                    Vectors.minus(position(mesh, mesh.vertex(f, 1)), a),
                    Vectors.minus(position(mesh, mesh.vertex(f, 2)), a));
            for (int corner = 0; corner < 3; corner++)
                around.get(mesh.vertex(f, corner)).add(ofFaces[f]);
        }
        Channel given = mesh.channel(Channel.Semantic.NORMAL);
        double[][] normals = new double[3 * mesh.faces()][];
        for (int c = 0; c < normals.length; c++) {
            int wedge = mesh.faceWedges()[c];
            normals[c] = given == null || given.isAbsent(wedge)
                    ? mean(around.get(mesh.wedgeVertices()[wedge]), ofFaces[c / 3], creaseCosine)
                    : new double[] {given.number(wedge, 0), given.number(wedge, 1), given.number(wedge, 2)};
        }
        return normals;
    }

    private static double[] mean(List<double[]> around, double[] own, double creaseCosine) {
        double[] sum = new double[3];
        for (double[] other : around) {
            if (Vectors.dot(Vectors.unit(own), Vectors.unit(other)) < creaseCosine) continue;
            for (int k = 0; k < 3; k++) sum[k] += other[k];
        }
        return Vectors.unit(sum);
    }

    private static double[] position(Mesh mesh, int vertex) {
        float[] p = mesh.positions();
        return new double[] {p[3 * vertex], p[3 * vertex + 1], p[3 * vertex + 2]};
    }

    /** One picture in the making. */
    private final class Canvas {
        final View view;
        final Shading light;
        final double[][] axes;
        final int width;
        final int height;
        final double[] depths;
        final double[][] colours;
        final double scale;

        Canvas(View view, Shading light, int width, int height) {
            this.view = view;
            this.light = light;
            this.width = width;
            this.height = height;
            axes = view.axes();
            depths = new double[width * height];
            Arrays.fill(depths, Double.POSITIVE_INFINITY);
            colours = new double[width * height][];
            scale = height / 2.0 / Math.tan(Math.toRadians(view.fieldOfView()) / 2);
        }

        void draw(int face) {
            double[][] eye = new double[3][];
            double[] x = new double[3];
            double[] y = new double[3];
            for (int c = 0; c < 3; c++) {
                eye[c] = toEye(Vectors.minus(position(mesh, mesh.vertex(face, c)), view.eye()));
                if (eye[c][2] >= 0) return;
                x[c] = width / 2.0 + scale * eye[c][0] / -eye[c][2];
                y[c] = height / 2.0 - scale * eye[c][1] / -eye[c][2];
            }
            double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
            if (area == 0) return;
            int lastX = (int) Math.min(width - 1, max(x));
            int lastY = (int) Math.min(height - 1, max(y));
            for (int py = (int) Math.max(0, min(y)); py <= lastY; py++) {
                for (int px = (int) Math.max(0, min(x)); px <= lastX; px++) {
                    double sx = px + .5;
                    double sy = py + .5;
                    double b0 = ((x[1] - sx) * (y[2] - sy) - (x[2] - sx) * (y[1] - sy)) / area;
                    double b1 = ((x[2] - sx) * (y[0] - sy) - (x[0] - sx) * (y[2] - sy)) / area;
                    double b2 = 1 - b0 - b1;
                    // y grows downwards: a face seen from its front turns clockwise here, which gives a negative area.
                    if (b0 >= 0 && b1 >= 0 && b2 >= 0)
                        sample(face, py * width + px, eye, new double[] {b0, b1, b2}, area < 0);
                }
            }
        }

        private void sample(int face, int at, double[][] eye, double[] weights, boolean front) {
            double sum = 0;
            for (int c = 0; c < 3; c++) sum += weights[c] /= -eye[c][2];
            double depth = 1 / sum;
            if (depth >= depths[at]) return;
            depths[at] = depth;
            double[] point = new double[3];
            double[] normal = new double[3];
            for (int c = 0; c < 3; c++) {
                weights[c] /= sum;
                for (int k = 0; k < 3; k++) {
                    point[k] += weights[c] * eye[c][k];
                    normal[k] += weights[c] * normals[3 * face + c][k];
                }
            }
            double[] toEye = Vectors.unit(new double[] {-point[0], -point[1], -point[2]});
            double[] n = Vectors.unit(toEye(normal));
            if (!front) n = new double[] {-n[0], -n[1], -n[2]};
            colours[at] = new double[3];
            light.shade(
                    albedo.at(face, weights, light.uncoloured()), n, toEye(new double[] {0, 1, 0}), toEye, colours[at]);
        }

        private double[] toEye(double[] direction) {
            return new double[] {
                Vectors.dot(axes[0], direction), Vectors.dot(axes[1], direction), Vectors.dot(axes[2], direction)
            };
        }

        int pixel(int x, int y) {
            double[] sum = new double[3];
            int hits = 0;
            for (int sy = 0; sy < SAMPLES; sy++) {
                for (int sx = 0; sx < SAMPLES; sx++) {
                    double[] c = colours[(y * SAMPLES + sy) * width + x * SAMPLES + sx];
                    if (c == null) continue;
                    hits++;
                    for (int k = 0; k < 3; k++) sum[k] += Albedo.srgb(c[k]);
                }
            }
            if (hits == 0) return 0;
            int argb = (int) Math.round(255.0 * hits / SAMPLES / SAMPLES);
            for (int k = 0; k < 3; k++) argb = argb << 8 | (int) Math.round(255 * sum[k] / hits);
            return argb;
        }

        private double min(double[] v) {
            return Math.min(v[0], Math.min(v[1], v[2]));
        }

        private double max(double[] v) {
            return Math.max(v[0], Math.max(v[1], v[2]));
        }
    }
}
