package org.jsmesh.test;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;

/** Small meshes of many kinds, the same for the same seed. */
public enum RandomMeshes {
    /** A rough height field, some faces of which are missing. */
    GRID_WITH_HOLES {
        @Override
        Parts parts(Random random) {
            Parts p = grid(random, 4 + random.nextInt(14), 4 + random.nextInt(14), 0.1);
            p.dropFaces(random, random.nextDouble() * 0.3);
            return p;
        }
    },
    /** A flat grid: many ties. */
    FLAT_GRID {
        @Override
        Parts parts(Random random) {
            return grid(random, 3 + random.nextInt(12), 3 + random.nextInt(12), 0);
        }
    },
    SPHERE {
        @Override
        Parts parts(Random random) {
            return sphere(random, 5 + random.nextInt(20), 4 + random.nextInt(14));
        }
    },
    /** A torus with a little noise. */
    TORUS {
        @Override
        Parts parts(Random random) {
            return torus(random, 3 + random.nextInt(16), 3 + random.nextInt(12));
        }
    },
    /** Random triangles over few vertices: edges of many faces, repeated and degenerate faces. */
    SOUP {
        @Override
        Parts parts(Random random) {
            Parts p = new Parts();
            int vertices = 4 + random.nextInt(20);
            for (int i = 0; i < vertices; i++) p.vertex(random.nextDouble(), random.nextDouble(), random.nextDouble());
            int faces = 1 + random.nextInt(60);
            for (int i = 0; i < faces; i++)
                p.face(random.nextInt(vertices), random.nextInt(vertices), random.nextInt(vertices));
            return p;
        }
    },
    /** Sheets that meet along borders of three and more faces per edge, and in points; with charts or without. */
    SHEETS {
        @Override
        Parts parts(Random random) {
            Parts p = sheets(random, 5 + random.nextInt(20), 3 + random.nextInt(6), 2 + random.nextInt(4), 0.1);
            int last = p.points.size() - 1;
            if (random.nextBoolean()) p.face(last, random.nextInt(last / 2), last / 2 + random.nextInt(last / 4));
            if (random.nextBoolean()) p.dropFaces(random, random.nextDouble() * 0.1);
            if (random.nextInt(3) > 0) {
                int block = 1 + random.nextInt(60);
                p.charts = new int[p.faces.size()];
                for (int f = 0; f < p.charts.length; f++) p.charts[f] = f / block % 3;
                p.normals = random.nextBoolean();
            }
            return p;
        }
    },
    /**
     * A sphere among many small things: triangles, pairs of them, tetrahedra, some of which touch; with charts or
     * materials or without.
     */
    CROWD {
        @Override
        Parts parts(Random random) {
            Parts p = sphere(random, 6 + random.nextInt(6), 4 + random.nextInt(6));
            for (int n = 10 + random.nextInt(120); n > 0; n--) {
                int first = p.points.size();
                double[] at = {3 * random.nextGaussian(), 3 * random.nextGaussian(), 3 * random.nextGaussian()};
                double size = .02 + .1 * random.nextDouble();
                for (int i = 0; i < 4; i++)
                    p.vertex(
                            at[0] + size * random.nextGaussian(),
                            at[1] + size * random.nextGaussian(),
                            at[2] + size * random.nextGaussian());
                int a = random.nextInt(4) == 0 ? random.nextInt(first) : first;
                int kind = random.nextInt(3);
                p.face(a, first + 1, first + 2);
                if (kind > 0) p.face(a, first + 3, first + 1);
                if (kind > 1) p.face(first + 1, first + 3, first + 2);
                if (kind > 1) p.face(first + 2, first + 3, a);
            }
            int block = 1 + random.nextInt(40);
            if (random.nextBoolean()) {
                p.charts = new int[p.faces.size()];
                for (int f = 0; f < p.charts.length; f++) p.charts[f] = f / block % 3;
                p.normals = random.nextBoolean();
            }
            if (random.nextInt(3) == 0) {
                p.materials = new int[p.faces.size()];
                for (int f = 0; f < p.materials.length; f++) p.materials[f] = f / block % 4 - 1;
            }
            return p;
        }
    },
    /** Tetrahedra that share vertices, some of them positions. */
    TETRAHEDRA {
        @Override
        Parts parts(Random random) {
            Parts p = new Parts();
            int vertices = 6 + random.nextInt(20);
            for (int i = 0; i < vertices; i++) p.vertex(random.nextInt(3), random.nextInt(3), random.nextDouble());
            for (int i = 1 + random.nextInt(8); i > 0; i--) {
                int a = random.nextInt(vertices - 3);
                p.face(a, a + 1, a + 2);
                p.face(a, a + 3, a + 1);
                p.face(a + 1, a + 3, a + 2);
                p.face(a + 2, a + 3, a);
            }
            return p;
        }
    },
    /** A torus in blocks of materials. */
    TORUS_WITH_MATERIALS {
        @Override
        Parts parts(Random random) {
            Parts p = torus(random, 8 + random.nextInt(12), 8 + random.nextInt(12));
            p.materials = new int[p.faces.size()];
            int block = 1 + random.nextInt(60);
            for (int f = 0; f < p.materials.length; f++) p.materials[f] = f / block % 4 - 1;
            return p;
        }
    },
    /** A height field in charts with texture coordinates of their own. */
    GRID_WITH_SEAMS {
        @Override
        Parts parts(Random random) {
            int columns = 6 + random.nextInt(12);
            Parts p = grid(random, columns, 6 + random.nextInt(12), 0.1);
            int width = 1 + random.nextInt(6);
            p.charts = new int[p.faces.size()];
            for (int f = 0; f < p.charts.length; f++) p.charts[f] = f / 2 % (columns - 1) / width;
            return p;
        }
    },
    /** A torus of creased patches of one normal each, where three and more creases meet. */
    CREASED {
        @Override
        Parts parts(Random random) {
            int columns = 6 + random.nextInt(12);
            Parts p = torus(random, columns, 6 + random.nextInt(12));
            if (random.nextInt(3) == 0) p.dropFaces(random, random.nextDouble() * 0.1);
            int width = 1 + random.nextInt(4);
            p.normals = true;
            p.charts = new int[p.faces.size()];
            if (random.nextBoolean()) p.materials = new int[p.faces.size()];
            for (int f = 0; f < p.charts.length; f++) {
                p.charts[f] = f / 2 % columns / width + 20 * (f / 2 / columns / width);
                if (p.materials != null) p.materials[f] = f / 60 % 2;
            }
            return p;
        }
    },
    /**
     * Two mirror images of a sphere whose coordinates are decimals, some of them off; with charts or normals, or
     * without.
     */
    MIRRORED {
        @Override
        Parts parts(Random random) {
            Parts p = sphere(random, 5 + random.nextInt(12), 4 + random.nextInt(10));
            int n = p.points.size();
            int faces = p.faces.size();
            int axis = random.nextInt(3);
            double sum = random.nextBoolean() ? 0 : random.nextInt(4000) / 1000.0;
            for (int v = 0; v < n; v++) {
                double[] at = p.points.get(v);
                for (int a = 0; a < 3; a++) at[a] = Math.rint(at[a] * 1000) / 1000;
                double[] image = at.clone();
                image[axis] = Math.rint((sum - at[axis]) * 1000) / 1000;
                if (random.nextInt(10) == 0) image[random.nextInt(3)] += (random.nextInt(9) - 4) / 1000.0;
                p.vertex(image[0], image[1], image[2]);
            }
            for (int f = 0; f < faces; f++) {
                int[] face = p.faces.get(f);
                p.face(n + face[0], n + face[2], n + face[1]);
            }
            if (random.nextInt(3) > 0) {
                p.charts = new int[p.faces.size()];
                for (int f = faces; f < p.charts.length; f++) p.charts[f] = 1;
                p.normals = random.nextBoolean();
            }
            return p;
        }
    },
    /** A sphere with materials, charts and holes at random: seams that end, branch and cross. */
    PATCHWORK {
        @Override
        Parts parts(Random random) {
            Parts p = sphere(random, 6 + random.nextInt(20), 6 + random.nextInt(14));
            if (random.nextBoolean()) p.dropFaces(random, random.nextDouble() * 0.1);
            p.materials = new int[p.faces.size()];
            p.charts = new int[p.faces.size()];
            int block = 4 + random.nextInt(40);
            for (int f = 0; f < p.charts.length; f++) {
                p.charts[f] = random.nextInt(12) == 0 ? 1 : 0;
                p.materials[f] = f / block % 2;
            }
            return p;
        }
    };

    abstract Parts parts(Random random);

    /** One mesh of this kind. */
    public Mesh mesh(long seed) {
        Parts parts = parts(new Random(seed));
        while (parts.faces.isEmpty()) parts = parts(new Random(++seed));
        return parts.build();
    }

    private static Parts grid(Random random, int columns, int rows, double roughness) {
        Parts p = new Parts();
        for (int y = 0; y < rows; y++) {
            for (int x = 0; x < columns; x++) p.vertex(x, y, roughness * random.nextGaussian());
        }
        for (int y = 0; y + 1 < rows; y++) {
            for (int x = 0; x + 1 < columns; x++) {
                int a = y * columns + x;
                p.quad(a, a + 1, a + columns + 1, a + columns);
            }
        }
        return p;
    }

    /** Flat sheets that meet along one border, like the leaves of a book. */
    public static Mesh book(int length, int leaves) {
        return sheets(new Random(1), length, length, leaves, 0).build();
    }

    private static Parts sheets(Random random, int length, int width, int leaves, double roughness) {
        Parts p = new Parts();
        for (int y = 0; y < length; y++) p.vertex(0, y, roughness * random.nextGaussian());
        for (int leaf = 0; leaf < leaves; leaf++) {
            double angle = 6 * leaf / (double) leaves;
            int first = p.points.size() - length;
            for (int x = 1; x < width; x++) {
                for (int y = 0; y < length; y++) {
                    double r = x + roughness * random.nextGaussian();
                    p.vertex(r * Math.cos(angle), y + roughness * random.nextGaussian(), r * Math.sin(angle));
                }
            }
            for (int x = 0; x + 1 < width; x++) {
                int left = x == 0 ? 0 : first + x * length;
                int right = first + (x + 1) * length;
                for (int y = 0; y + 1 < length; y++) p.quad(left + y, right + y, right + y + 1, left + y + 1);
            }
        }
        return p;
    }

    private static Parts sphere(Random random, int columns, int rows) {
        Parts p = new Parts();
        p.vertex(0, 0, 1);
        for (int y = 1; y < rows; y++) {
            for (int x = 0; x < columns; x++) {
                double theta = Math.PI * y / rows;
                double phi = 2 * Math.PI * x / columns;
                double r = 1 + 0.02 * random.nextGaussian();
                p.vertex(r * Math.sin(theta) * Math.cos(phi), r * Math.sin(theta) * Math.sin(phi), r * Math.cos(theta));
            }
        }
        p.vertex(0, 0, -1);
        int south = 1 + (rows - 1) * columns;
        for (int x = 0; x < columns; x++) {
            int right = (x + 1) % columns;
            p.face(0, 1 + x, 1 + right);
            for (int y = 0; y + 2 < rows; y++) {
                int a = 1 + y * columns;
                p.quad(a + x, a + columns + x, a + columns + right, a + right);
            }
            p.face(south, south - columns + right, south - columns + x);
        }
        return p;
    }

    private static Parts torus(Random random, int columns, int rows) {
        Parts p = new Parts();
        for (int y = 0; y < rows; y++) {
            for (int x = 0; x < columns; x++) {
                double phi = 2 * Math.PI * x / columns;
                double theta = 2 * Math.PI * y / rows;
                double r = 3 + Math.cos(theta) + 0.03 * random.nextGaussian();
                p.vertex(r * Math.cos(phi), r * Math.sin(phi), Math.sin(theta));
            }
        }
        for (int y = 0; y < rows; y++) {
            for (int x = 0; x < columns; x++) {
                int right = (x + 1) % columns;
                int up = (y + 1) % rows * columns;
                p.quad(y * columns + x, y * columns + right, up + right, up + x);
            }
        }
        return p;
    }

    /** A mesh in the making. */
    private static final class Parts {
        final List<double[]> points = new ArrayList<>();
        List<int[]> faces = new ArrayList<>();
        int[] materials;
        /** Faces of different charts share no wedge. */
        int[] charts;
        /** Do charts differ in normals, not in texture coordinates? */
        boolean normals;

        void vertex(double x, double y, double z) {
            points.add(new double[] {x, y, z});
        }

        void face(int a, int b, int c) {
            faces.add(new int[] {a, b, c});
        }

        void quad(int a, int b, int c, int d) {
            face(a, b, c);
            face(a, c, d);
        }

        void dropFaces(Random random, double share) {
            faces.removeIf(f -> random.nextDouble() < share);
        }

        Mesh build() {
            float[] positions = new float[3 * points.size()];
            for (int i = 0; i < positions.length; i++) positions[i] = (float) points.get(i / 3)[i % 3];
            int[] faceWedges = new int[3 * faces.size()];
            for (int i = 0; i < faceWedges.length; i++) faceWedges[i] = faces.get(i / 3)[i % 3];
            MeshBuilder builder = new MeshBuilder().positions(positions).faceWedges(faceWedges);
            if (materials != null) {
                int most = Arrays.stream(materials).max().orElse(-1);
                List<Material> list = new ArrayList<>();
                for (int i = 0; i <= most; i++) list.add(Material.named("m" + i));
                builder.faceMaterials(materials).materials(list);
            }
            if (charts != null) addSeams(builder, faceWedges, positions);
            return builder.build();
        }

        private void addSeams(MeshBuilder builder, int[] faceWedges, float[] positions) {
            int chartCount = Arrays.stream(charts).max().orElse(0) + 1;
            int[] wedgeOf = new int[points.size() * chartCount];
            List<Integer> vertices = new ArrayList<>();
            List<Integer> values = new ArrayList<>();
            for (int i = 0; i < faceWedges.length; i++) {
                int v = faceWedges[i];
                int key = v * chartCount + charts[i / 3];
                if (wedgeOf[key] == 0) {
                    vertices.add(v);
                    values.add(Float.floatToIntBits(positions[3 * v] + charts[i / 3]));
                    values.add(Float.floatToIntBits(positions[3 * v + 1]));
                    if (normals) values.add(Float.floatToIntBits(charts[i / 3] % 3));
                    wedgeOf[key] = vertices.size();
                }
                faceWedges[i] = wedgeOf[key] - 1;
            }
            builder.wedgeVertices(vertices.stream().mapToInt(i -> i).toArray())
                    .channels(List.of(new Channel(
                            normals ? Channel.Semantic.NORMAL : Channel.Semantic.TEXCOORD,
                            normals ? "normal" : "uv",
                            normals ? 3 : 2,
                            Channel.Type.FLOAT32,
                            values.stream().mapToInt(i -> i).toArray(),
                            null)));
        }
    }
}
