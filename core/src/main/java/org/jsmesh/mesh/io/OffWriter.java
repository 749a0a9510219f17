package org.jsmesh.mesh.io;

import java.io.IOException;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;

/** Writes OFF text. With attributes there is a vertex per wedge. A material has its colour written. */
final class OffWriter {
    private final Mesh mesh;
    private final HeldChannels held;

    OffWriter(Mesh mesh, List<String> notes) {
        this.mesh = mesh;
        held = new HeldChannels(mesh, 2, "OFF", notes);
        held.noteAbsent("OFF", notes);
        if (!mesh.materials().stream().allMatch(OffWriter::isColour))
            notes.add("OFF holds only the colours of materials.");
        if (!mesh.textures().isEmpty()) notes.add("Textures not written.");
    }

    private static boolean isColour(Material material) {
        List<String> keys =
                material.parameters().stream().map(Material.Parameter::key).toList();
        float[] rgb = material.parameter("rgb");
        return material.textures().isEmpty()
                && (keys.equals(List.of("rgb"))
                        || keys.equals(List.of("rgb", "d")) && material.parameter("d").length == 1)
                && rgb.length == 3
                && material.name().equals(FaceColour.name(rgb));
    }

    void write(String fileName, ResourceSink sink) throws IOException {
        try (TextOutput out = new TextOutput(sink.create(fileName))) {
            int vertices = held.any() ? mesh.wedges() : mesh.vertices();
            if (held.texcoord() != null) out.text("ST");
            if (held.colour() != null) out.text("C");
            if (held.normal() != null) out.text("N");
            out.text("OFF")
                    .line()
                    .number(vertices)
                    .text(" ")
                    .number(mesh.faces())
                    .text(" 0")
                    .line();
            for (int v = 0; v < vertices; v++) vertex(out, v);
            for (int f = 0; f < mesh.faces(); f++) face(out, f);
        }
    }

    private void vertex(TextOutput out, int v) throws IOException {
        int p = 3 * (held.any() ? mesh.wedgeVertices()[v] : v);
        float[] xyz = mesh.positions();
        out.number(xyz[p]).text(" ").number(xyz[p + 1]).text(" ").number(xyz[p + 2]);
        if (held.normal() != null) out.floats(held.normal().values(), 3 * v, 3);
        if (held.colour() != null) colour(out, held.colour(), v);
        if (held.texcoord() != null) out.floats(held.texcoord().values(), 2 * v, 2);
        out.line();
    }

    private static void colour(TextOutput out, Channel colour, int wedge) throws IOException {
        int n = colour.components();
        for (int i = wedge * n; i < wedge * n + n; i++) {
            out.text(" ");
            if (colour.type() == Channel.Type.UINT8) {
                out.number(colour.values()[i]);
            } else {
                out.decimal(Float.intBitsToFloat(colour.values()[i]));
            }
        }
    }

    private void face(TextOutput out, int face) throws IOException {
        out.text("3");
        for (int i = 0; i < 3; i++)
            out.text(" ").number(held.any() ? mesh.faceWedges()[3 * face + i] : mesh.vertex(face, i));
        int id = mesh.faceMaterials()[face];
        if (id >= 0) {
            Material material = mesh.materials().get(id);
            float[] colour = material.displayColour();
            int count = material.parameter("d") != null || colour[3] != 1 ? 4 : 3;
            for (int i = 0; i < count; i++) out.text(" ").decimal(colour[i]);
        }
        out.line();
    }
}
