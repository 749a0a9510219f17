package org.jsmesh.spark;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;

/** Writes the models of {@code src/bench/catalogue.sh}: bumpy spheres of 2,000 to 20,000 faces. */
public final class BenchModels {
    private static final int FEWEST = 2_000;
    private static final int MOST = 20_000;

    private BenchModels() {}

    /**
     * Writes models into two folders, one after another in turn, so that these are alike.
     *
     * @param args folder, number of models
     */
    public static void main(String[] args) throws IOException {
        int count = Integer.parseInt(args[1]);
        Random random = new Random(1);
        long faces = 0;
        for (int i = 0; i < count; i++) {
            Path folder = Files.createDirectories(Path.of(args[0], i % 2 == 0 ? "a" : "b"));
            int rows = (int) Math.sqrt((FEWEST + random.nextInt(MOST - FEWEST)) / 4.0);
            faces += write(folder.resolve(String.format("ball-%05d.ply", i)), rows, random.nextInt(1000));
        }
        System.out.println(count + " models, " + faces + " faces");
    }

    private static int write(Path file, int rows, int seed) throws IOException {
        int columns = 2 * rows;
        int faces = 2 * columns * (rows - 1);
        int vertices = columns * rows;
        String header = "ply\nformat binary_little_endian 1.0\nelement vertex " + vertices
                + "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces
                + "\nproperty list uchar int vertex_indices\nend_header\n";
        ByteBuffer bytes = ByteBuffer.allocate(header.length() + 12 * vertices + 13 * faces)
                .order(ByteOrder.LITTLE_ENDIAN)
                .put(header.getBytes(StandardCharsets.US_ASCII));
        for (int row = 0; row < rows; row++) {
            double polar = Math.PI * (row + .5) / rows;
            for (int column = 0; column < columns; column++) {
                double around = 2 * Math.PI * column / columns;
                double r = 1 + .1 * Math.sin(5 * around + seed) * Math.sin(4 * polar) + .02 * Math.cos(23 * polar);
                bytes.putFloat((float) (r * Math.sin(polar) * Math.cos(around)));
                bytes.putFloat((float) (r * Math.sin(polar) * Math.sin(around)));
                bytes.putFloat((float) (r * Math.cos(polar)));
            }
        }
        for (int row = 0; row < rows - 1; row++)
            for (int column = 0; column < columns; column++) {
                int a = row * columns + column;
                int b = row * columns + (column + 1) % columns;
                bytes.put((byte) 3).putInt(a).putInt(a + columns).putInt(b);
                bytes.put((byte) 3).putInt(b).putInt(a + columns).putInt(b + columns);
            }
        Files.write(file, bytes.array());
        return faces;
    }
}
