package org.jsmesh.test;

import java.util.Random;

/** The shapes that random meshes begin with. */
final class MeshShapes {
    private MeshShapes() {}

    static MeshParts grid(Random random, int columns, int rows, double roughness) {
        MeshParts p = new MeshParts();
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

    static MeshParts sheets(Random random, int length, int width, int leaves, double roughness) {
        MeshParts p = new MeshParts();
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

    static MeshParts sphere(Random random, int columns, int rows) {
        MeshParts p = new MeshParts();
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

    static MeshParts torus(Random random, int columns, int rows) {
        MeshParts p = new MeshParts();
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
}
