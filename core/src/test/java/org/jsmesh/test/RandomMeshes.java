package org.jsmesh.test;

import java.util.Random;
import org.jsmesh.mesh.Mesh;

/** Small meshes of many kinds, the same for the same seed. */
public enum RandomMeshes {
    /** A rough height field, some faces of which are missing. */
    GRID_WITH_HOLES {
        @Override
        MeshParts parts(Random random) {
            MeshParts p = MeshShapes.grid(random, 4 + random.nextInt(14), 4 + random.nextInt(14), 0.1);
            p.dropFaces(random, random.nextDouble() * 0.3);
            return p;
        }
    },
    /** A flat grid: many ties. */
    FLAT_GRID {
        @Override
        MeshParts parts(Random random) {
            return MeshShapes.grid(random, 3 + random.nextInt(12), 3 + random.nextInt(12), 0);
        }
    },
    SPHERE {
        @Override
        MeshParts parts(Random random) {
            return MeshShapes.sphere(random, 5 + random.nextInt(20), 4 + random.nextInt(14));
        }
    },
    /** A torus with a little noise. */
    TORUS {
        @Override
        MeshParts parts(Random random) {
            return MeshShapes.torus(random, 3 + random.nextInt(16), 3 + random.nextInt(12));
        }
    },
    /** Random triangles over few vertices: edges of many faces, repeated and degenerate faces. */
    SOUP {
        @Override
        MeshParts parts(Random random) {
            MeshParts p = new MeshParts();
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
        MeshParts parts(Random random) {
            MeshParts p = MeshShapes.sheets(
                    random, 5 + random.nextInt(20), 3 + random.nextInt(6), 2 + random.nextInt(4), 0.1);
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
        MeshParts parts(Random random) {
            MeshParts p = MeshShapes.sphere(random, 6 + random.nextInt(6), 4 + random.nextInt(6));
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
        MeshParts parts(Random random) {
            MeshParts p = new MeshParts();
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
        MeshParts parts(Random random) {
            MeshParts p = MeshShapes.torus(random, 8 + random.nextInt(12), 8 + random.nextInt(12));
            p.materials = new int[p.faces.size()];
            int block = 1 + random.nextInt(60);
            for (int f = 0; f < p.materials.length; f++) p.materials[f] = f / block % 4 - 1;
            return p;
        }
    },
    /** A height field in charts with texture coordinates of their own. */
    GRID_WITH_SEAMS {
        @Override
        MeshParts parts(Random random) {
            int columns = 6 + random.nextInt(12);
            MeshParts p = MeshShapes.grid(random, columns, 6 + random.nextInt(12), 0.1);
            int width = 1 + random.nextInt(6);
            p.charts = new int[p.faces.size()];
            for (int f = 0; f < p.charts.length; f++) p.charts[f] = f / 2 % (columns - 1) / width;
            return p;
        }
    },
    /** A torus of creased patches of one normal each, where three and more creases meet. */
    CREASED {
        @Override
        MeshParts parts(Random random) {
            int columns = 6 + random.nextInt(12);
            MeshParts p = MeshShapes.torus(random, columns, 6 + random.nextInt(12));
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
        MeshParts parts(Random random) {
            MeshParts p = MeshShapes.sphere(random, 5 + random.nextInt(12), 4 + random.nextInt(10));
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
        MeshParts parts(Random random) {
            MeshParts p = MeshShapes.sphere(random, 6 + random.nextInt(20), 6 + random.nextInt(14));
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

    abstract MeshParts parts(Random random);

    /** One mesh of this kind. */
    public Mesh mesh(long seed) {
        MeshParts parts = parts(new Random(seed));
        while (parts.faces.isEmpty()) parts = parts(new Random(++seed));
        return parts.build();
    }

    /** Flat sheets that meet along one border, like the leaves of a book. */
    public static Mesh book(int length, int leaves) {
        return MeshShapes.sheets(new Random(1), length, length, leaves, 0).build();
    }
}
