package org.jsmesh.spark;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/** Small model files: wavy patches of 2 (n - 1)² faces. */
final class Patches {
    private Patches() {}

    static Path write(Path file, int n, int seed) throws IOException {
        Files.createDirectories(file.getParent());
        return Files.writeString(file, ply(n, seed));
    }

    static String ply(int n, int seed) {
        StringBuilder text = new StringBuilder("ply\nformat ascii 1.0\nelement vertex " + n * n
                + "\nproperty float x\nproperty float y\nproperty float z\nelement face " + 2 * (n - 1) * (n - 1)
                + "\nproperty list uchar int vertex_indices\nend_header\n");
        vertices(text, "", n, seed);
        for (int[] face : faces(n)) text.append("3 " + face[0] + " " + face[1] + " " + face[2] + "\n");
        return text.toString();
    }

    /** With a library and a picture that is missing. */
    static Path writeObj(Path file, int n, String library) throws IOException {
        StringBuilder text = new StringBuilder("mtllib " + library + "\nusemtl red\n");
        vertices(text, "v ", n, 1);
        for (int[] face : faces(n))
            text.append("f " + (face[0] + 1) + " " + (face[1] + 1) + " " + (face[2] + 1) + "\n");
        Files.createDirectories(file.getParent());
        return Files.writeString(file, text);
    }

    private static void vertices(StringBuilder text, String begin, int n, int seed) {
        for (int i = 0; i < n * n; i++) {
            double x = i % n;
            double y = i / n;
            double z = Math.sin(x * .7 + seed) * Math.cos(y * .5);
            text.append(begin).append(String.format(Locale.ROOT, "%.4f %.4f %.4f%n", x, y, z));
        }
    }

    private static int[][] faces(int n) {
        int[][] faces = new int[2 * (n - 1) * (n - 1)][];
        int count = 0;
        for (int y = 0; y < n - 1; y++)
            for (int x = 0; x < n - 1; x++) {
                int a = y * n + x;
                faces[count++] = new int[] {a, a + 1, a + n};
                faces[count++] = new int[] {a + 1, a + n + 1, a + n};
            }
        return faces;
    }
}
