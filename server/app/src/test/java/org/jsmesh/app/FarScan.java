package org.jsmesh.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/** Writes a terrain as a scanner gives it: coordinates of a map projection in metres, to the millimetre, as OBJ. */
final class FarScan {
    /** Side of the terrain in metres. */
    private static final int SIDE = 20;

    private FarScan() {}

    /** A terrain of {@code points} × {@code points} vertices whose corner is at a place, about so many metres high. */
    static Path write(Path file, int points, double east, double north, int up) throws IOException {
        StringBuilder obj = new StringBuilder();
        for (int y = 0; y < points; y++) {
            for (int x = 0; x < points; x++) {
                double across = SIDE * x / (points - 1.0);
                double along = SIDE * y / (points - 1.0);
                double height =
                        2 * Math.sin(.5 * across) * Math.cos(.4 * along) + .05 * Math.sin(7 * across + 5 * along);
                long millimetres = Math.round(1000 * height) + 1000L * up;
                obj.append(String.format(
                        Locale.ROOT,
                        "v %.3f %.3f %.3f\n",
                        east + Math.round(1000 * across) / 1000.0,
                        north + Math.round(1000 * along) / 1000.0,
                        millimetres / 1000.0));
            }
        }
        for (int y = 0; y + 1 < points; y++) {
            for (int x = 0; x + 1 < points; x++) {
                int v = y * points + x + 1;
                obj.append("f " + v + " " + (v + 1) + " " + (v + points + 1) + "\n");
                obj.append("f " + v + " " + (v + points + 1) + " " + (v + points) + "\n");
            }
        }
        return Files.writeString(file, obj);
    }
}
