package org.jsmesh.bench;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshCleaner;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.io.ModelReader;
import org.jsmesh.mesh.io.ResourceResolver;

/** The meshes that are measured: positions and faces, with attributes or without. */
public final class BenchmarkMesh {
    /** Name of the mesh that needs no file. */
    public static final String GENERATED = "generated";

    private static final int AROUND = 320;
    private static final int ACROSS = 160;
    private static final double DECIMALS = 1e5;

    private BenchmarkMesh() {}

    /**
     * Without attributes.
     *
     * @param model a file, or {@link #GENERATED}
     */
    public static Mesh read(String model) {
        if (model.equals(GENERATED)) return torus();
        Mesh mesh = file(model);
        return MeshCleaner.clean(
                new MeshBuilder()
                        .positions(mesh.positions())
                        .faceWedges(triangles(mesh))
                        .build(),
                new ArrayList<>());
    }

    /** The same with its attributes; those of the generated one are normals and texture coordinates. */
    public static Mesh readWhole(String model) {
        return model.equals(GENERATED) ? withAttributes(torus()) : MeshCleaner.clean(file(model), new ArrayList<>());
    }

    private static Mesh file(String model) {
        Path file = Path.of(model);
        try {
            return ModelReader.read(file.getFileName().toString(), Files.readAllBytes(file), ResourceResolver.NONE)
                    .mesh();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Three vertices per face. */
    public static int[] triangles(Mesh mesh) {
        int[] corners = mesh.faceWedges().clone();
        for (int i = 0; i < corners.length; i++) corners[i] = mesh.wedgeVertices()[corners[i]];
        return corners;
    }

    /** The archive of a mesh. */
    public static byte[] archive(Mesh mesh) {
        return new MeshEncoder(EncoderSettings.defaults())
                .encode(mesh, ProgressListener.NONE)
                .bytes();
    }

    /** A torus of 102,400 faces with waves and a little roughness, in decimals as models are published. */
    private static Mesh torus() {
        float[] positions = new float[3 * AROUND * ACROSS];
        int[] corners = new int[6 * AROUND * ACROSS];
        Random random = new Random(1);
        for (int y = 0; y < ACROSS; y++) {
            for (int x = 0; x < AROUND; x++) {
                double phi = 2 * Math.PI * (x + .3 * random.nextDouble()) / AROUND;
                double theta = 2 * Math.PI * (y + .3 * random.nextDouble()) / ACROSS;
                double tube = 1 + .15 * Math.sin(7 * phi) * Math.cos(5 * theta) + .001 * random.nextGaussian();
                double r = 2.5 + tube * Math.cos(theta);
                int v = y * AROUND + x;
                positions[3 * v] = decimal(r * Math.cos(phi));
                positions[3 * v + 1] = decimal(r * Math.sin(phi));
                positions[3 * v + 2] = decimal(tube * Math.sin(theta));
                int right = y * AROUND + (x + 1) % AROUND;
                int up = (y + 1) % ACROSS * AROUND;
                int[] quad = {v, right, up + (x + 1) % AROUND, v, up + (x + 1) % AROUND, up + x};
                System.arraycopy(quad, 0, corners, 6 * v, 6);
            }
        }
        return new MeshBuilder().positions(positions).faceWedges(corners).build();
    }

    private static Mesh withAttributes(Mesh torus) {
        int n = torus.vertices();
        int[] normals = new int[3 * n];
        int[] uv = new int[2 * n];
        for (int v = 0; v < n; v++) {
            double phi = 2 * Math.PI * (v % AROUND) / AROUND;
            double theta = 2 * Math.PI * (v / AROUND) / ACROSS;
            normals[3 * v] = Float.floatToIntBits(decimal(Math.cos(phi) * Math.cos(theta)));
            normals[3 * v + 1] = Float.floatToIntBits(decimal(Math.sin(phi) * Math.cos(theta)));
            normals[3 * v + 2] = Float.floatToIntBits(decimal(Math.sin(theta)));
            uv[2 * v] = Float.floatToIntBits(decimal((double) (v % AROUND) / AROUND));
            uv[2 * v + 1] = Float.floatToIntBits(decimal((double) (v / AROUND) / ACROSS));
        }
        return new MeshBuilder()
                .positions(torus.positions())
                .faceWedges(torus.faceWedges())
                .channels(List.of(
                        new Channel(Channel.Semantic.NORMAL, "normal", 3, Channel.Type.FLOAT32, normals, null),
                        new Channel(Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, uv, null)))
                .build();
    }

    private static float decimal(double x) {
        return (float) (Math.rint(x * DECIMALS) / DECIMALS);
    }
}
