package org.jsmesh.mesh.io;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;

/** Writes binary STL: positions only, with the normal of each facet. */
final class StlWriter {
    private final Mesh mesh;

    StlWriter(Mesh mesh, List<String> notes) {
        this.mesh = mesh;
        List<String> channels = mesh.channels().stream().map(Channel::name).toList();
        if (!channels.isEmpty()) notes.add("STL does not hold these channels: " + Notes.names(channels) + ".");
        if (!mesh.materials().isEmpty()) notes.add("STL does not hold materials and textures.");
    }

    void write(String fileName, ResourceSink sink) throws IOException {
        try (LittleEndianOutput out = new LittleEndianOutput(sink.create(fileName))) {
            byte[] header = Arrays.copyOf(
                    "binary STL written by jSM".getBytes(StandardCharsets.US_ASCII), StlReader.HEADER_BYTES);
            out.write(header);
            out.writeInt(mesh.faces());
            for (int f = 0; f < mesh.faces(); f++) facet(out, f);
        }
    }

    private void facet(LittleEndianOutput out, int face) throws IOException {
        float[] p = mesh.positions();
        int a = 3 * mesh.vertex(face, 0);
        int b = 3 * mesh.vertex(face, 1);
        int c = 3 * mesh.vertex(face, 2);
        double[] u = {(double) p[b] - p[a], (double) p[b + 1] - p[a + 1], (double) p[b + 2] - p[a + 2]};
        double[] v = {(double) p[c] - p[a], (double) p[c + 1] - p[a + 1], (double) p[c + 2] - p[a + 2]};
        double[] n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
        double length = Math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (int i = 0; i < 3; i++) out.writeFloat(length > 0 ? (float) (n[i] / length) : 0f);
        for (int corner : new int[] {a, b, c}) {
            for (int i = 0; i < 3; i++) out.writeFloat(p[corner + i]);
        }
        out.writeShort(0);
    }
}
