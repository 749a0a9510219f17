package org.jsmesh.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/** Writes a closed bumpy torus as ASCII PLY: a small organic model for the tests of the commands. */
public final class Bumpy {
    private Bumpy() {}

    /**
     * @param rings vertices around, a third as many across
     * @return the text: 2 · rings · rings/3 faces
     */
    public static String torus(int rings) {
        int sides = rings / 3;
        StringBuilder ply = new StringBuilder("ply\nformat ascii 1.0\nelement vertex " + rings * sides + "\n"
                + "property float x\nproperty float y\nproperty float z\nelement face " + 2 * rings * sides
                + "\nproperty list uchar int vertex_indices\nend_header\n");
        for (int i = 0; i < rings; i++) {
            for (int j = 0; j < sides; j++) {
                double a = 2 * Math.PI * i / rings;
                double b = 2 * Math.PI * j / sides;
                double r = 1 + .08 * Math.sin(5 * a) * Math.cos(3 * b);
                ply.append(String.format(
                        Locale.ROOT,
                        "%.6f %.6f %.6f\n",
                        (3 + r * Math.cos(b)) * Math.cos(a),
                        (3 + r * Math.cos(b)) * Math.sin(a),
                        r * Math.sin(b)));
            }
        }
        for (int i = 0; i < rings; i++) {
            for (int j = 0; j < sides; j++) {
                int p = i * sides + j;
                int q = (i + 1) % rings * sides + j;
                int r = (i + 1) % rings * sides + (j + 1) % sides;
                int s = i * sides + (j + 1) % sides;
                ply.append("3 " + p + " " + q + " " + r + "\n3 " + p + " " + r + " " + s + "\n");
            }
        }
        return ply.toString();
    }

    public static Path write(Path file, int rings) throws IOException {
        return Files.writeString(file, torus(rings));
    }
}
