package org.jsmesh.app;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jsmesh.test.AlteredPicture;

/** Models of which archives have all, or not all, and archives of them. */
final class ClaimedModels {
    private static final int SIDE = 12;

    private ClaimedModels() {}

    /** A bump with a picture. */
    static Path painted(Path folder) throws IOException {
        Files.createDirectories(folder);
        Files.writeString(folder.resolve("painted.mtl"), "newmtl wood\nKd 1 1 1\nmap_Kd wood.png\n");
        Files.write(folder.resolve("wood.png"), Files.readAllBytes(Path.of("..", "..", "models", "amphora.png")));
        return Files.writeString(folder.resolve("painted.obj"), "mtllib painted.mtl\nusemtl wood\n" + bump());
    }

    /** The same where the picture is missing. */
    static Path unpainted(Path folder) throws IOException {
        Path model = painted(folder);
        Files.delete(folder.resolve("wood.png"));
        return model;
    }

    /** A mesh whose file has an element that no reader knows. */
    static Path annotated(Path file) throws IOException {
        return Files.writeString(
                file,
                "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                        + "element face 4\nproperty list uchar int vertex_indices\nelement hinge 1\nproperty int a\n"
                        + "end_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n7\n");
    }

    /** The archive of a model. */
    static Path archive(Path model, Path archive) {
        Cli.ok("encode", model, "-o", archive);
        return archive;
    }

    /** An archive whose picture was altered, and its checksums mended. */
    static Path altered(Path archive, Path altered) {
        try {
            return Files.write(altered, AlteredPicture.in(Files.readAllBytes(archive)));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String bump() {
        StringBuilder obj = new StringBuilder();
        for (int i = 0; i < SIDE * SIDE; i++) {
            int x = i % SIDE;
            int y = i / SIDE;
            obj.append("v ")
                    .append(x)
                    .append(' ')
                    .append(y)
                    .append(' ')
                    .append(x * y % 5)
                    .append('\n');
            obj.append("vt ").append(x / 16.0).append(' ').append(y / 16.0).append('\n');
        }
        for (int y = 0; y + 1 < SIDE; y++) {
            for (int x = 0; x + 1 < SIDE; x++) {
                int a = y * SIDE + x + 1;
                face(obj, a, a + 1, a + SIDE);
                face(obj, a + 1, a + SIDE + 1, a + SIDE);
            }
        }
        return obj.toString();
    }

    private static void face(StringBuilder obj, int a, int b, int c) {
        obj.append("f ").append(a).append('/').append(a);
        obj.append(' ').append(b).append('/').append(b);
        obj.append(' ').append(c).append('/').append(c).append('\n');
    }
}
