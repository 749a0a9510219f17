package org.jsmesh.app;

import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;

/** A torus with vertex colours and a fine grain that no codec can foresee, so that it has many bytes for its faces. */
final class GrainyTorus {
    private static final double GRAIN = 2e-3;

    private GrainyTorus() {}

    /** Writes 2 · around · across faces as binary PLY. */
    static Path write(Path file, int around, int across) throws IOException {
        Random grain = new Random(42);
        try (OutputStream out = Files.newOutputStream(file);
                DataOutputStream data = new DataOutputStream(new java.io.BufferedOutputStream(out))) {
            data.writeBytes("ply\nformat binary_big_endian 1.0\nelement vertex " + around * across + "\n"
                    + "property float x\nproperty float y\nproperty float z\n"
                    + "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                    + "element face " + 2 * around * across + "\nproperty list uchar int vertex_indices\nend_header\n");
            for (int i = 0; i < around * across; i++) {
                double u = 2 * Math.PI * (i / across) / around;
                double v = 2 * Math.PI * (i % across) / across;
                double r = .4 + .03 * Math.sin(5 * u) * Math.cos(3 * v) + GRAIN * grain.nextGaussian();
                data.writeFloat((float) ((1 + r * Math.cos(v)) * Math.cos(u)));
                data.writeFloat((float) (r * Math.sin(v)));
                data.writeFloat((float) ((1 + r * Math.cos(v)) * Math.sin(u)));
                data.writeByte((int) (150 + 90 * Math.sin(u)));
                data.writeByte((int) (150 + 90 * Math.cos(2 * v)));
                data.writeByte((int) (150 + 90 * Math.sin(u + v)));
            }
            for (int i = 0; i < around; i++) {
                for (int j = 0; j < across; j++) {
                    int a = i * across + j;
                    int b = (i + 1) % around * across + j;
                    int c = (i + 1) % around * across + (j + 1) % across;
                    int d = i * across + (j + 1) % across;
                    for (int[] face : new int[][] {{a, d, b}, {b, d, c}}) {
                        data.writeByte(3);
                        for (int corner : face) data.writeInt(corner);
                    }
                }
            }
        }
        return file;
    }
}
