package org.jsmesh.mesh.io;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;

/**
 * Writes binary little-endian PLY. With attributes there is a vertex per wedge, at the very position of its vertex, so
 * that a reader can weld them again.
 */
final class PlyWriter {
    private static final String[] COLOURS = {"red", "green", "blue", "alpha"};

    private final Mesh mesh;
    private final List<String> notes;
    private final HeldChannels held;
    private final PlyScalars scalars;
    private final PlyMaterials materials;

    PlyWriter(Mesh mesh, List<String> notes) {
        this.mesh = mesh;
        this.notes = notes;
        scalars = new PlyScalars(mesh, notes);
        held = new HeldChannels(mesh, 2, "PLY", scalars.channels(), notes);
        held.noteAbsent("PLY", notes);
        scalars.noteAbsent(notes);
        materials = new PlyMaterials(mesh, notes);
    }

    void write(String fileName, ResourceSink sink) throws IOException {
        try (LittleEndianOutput out = new LittleEndianOutput(sink.create(fileName))) {
            out.write(header().getBytes(StandardCharsets.UTF_8));
            int vertices = held.any() ? mesh.wedges() : mesh.vertices();
            for (int v = 0; v < vertices; v++) vertex(out, v);
            for (int f = 0; f < mesh.faces(); f++) face(out, f);
        }
        if (!materials.textures().isEmpty()) {
            TextureFiles files = new TextureFiles(List.of(fileName), notes);
            files.write(mesh, sink);
            if (!files.areUnchanged()) notes.add("Comments TextureFile still name the former paths.");
        } else if (!mesh.textures().isEmpty()) {
            notes.add("Textures not written.");
        }
    }

    private String header() {
        StringBuilder text = new StringBuilder("ply\nformat binary_little_endian 1.0\ncomment written by jSM\n");
        for (String path : materials.textures())
            text.append("comment TextureFile ").append(path).append('\n');
        text.append("element vertex ")
                .append(held.any() ? mesh.wedges() : mesh.vertices())
                .append('\n');
        properties(text, mesh.isDouble() ? "double" : "float", "x", "y", "z");
        if (held.normal() != null) properties(text, "float", "nx", "ny", "nz");
        if (held.texcoord() != null) properties(text, "float", "s", "t");
        if (held.colour() != null) {
            String type = PlyType.of(held.colour().type()).typeName();
            for (int i = 0; i < held.colour().components(); i++) properties(text, type, COLOURS[i]);
        }
        scalars.vertexHeader(text);
        text.append("element face ").append(mesh.faces()).append("\nproperty list uchar int vertex_indices\n");
        materials.header(text);
        scalars.faceHeader(text);
        return text.append("end_header\n").toString();
    }

    private static void properties(StringBuilder text, String type, String... names) {
        for (String name : names)
            text.append("property ").append(type).append(' ').append(name).append('\n');
    }

    private void vertex(LittleEndianOutput out, int v) throws IOException {
        int vertex = held.any() ? mesh.wedgeVertices()[v] : v;
        for (int i = 0; i < 3; i++) {
            if (mesh.isDouble()) out.writeDouble(mesh.coordinate(vertex, i));
            else out.writeFloat(mesh.positions()[3 * vertex + i]);
        }
        values(out, held.normal(), v);
        values(out, held.texcoord(), v);
        values(out, held.colour(), v);
        scalars.vertex(out, v);
    }

    private static void values(LittleEndianOutput out, Channel channel, int wedge) throws IOException {
        if (channel == null) return;
        PlyScalars.values(out, channel.type(), channel.values(), wedge * channel.words(), channel.words());
    }

    private void face(LittleEndianOutput out, int face) throws IOException {
        out.writeByte(3);
        for (int i = 0; i < 3; i++) out.writeInt(held.any() ? mesh.faceWedges()[3 * face + i] : mesh.vertex(face, i));
        materials.face(out, face);
        scalars.face(out, face);
    }
}
