package org.jsmesh.mesh.io;

import java.io.IOException;
import java.util.List;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
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
        if (held.colour() != null && !keepsType(held.colour()))
            notes.add("OFF does not say of which type colours are: those of "
                    + held.colour().name() + " come back as others.");
        List<String> ofFaces =
                mesh.faceChannels().stream().map(FaceChannel::name).toList();
        if (!ofFaces.isEmpty()) notes.add("OFF does not hold these attributes of faces: " + Notes.names(ofFaces) + ".");
        if (!mesh.materials().stream().allMatch(FaceColour::is)) notes.add("OFF holds only the colours of materials.");
        if (!mesh.textures().isEmpty()) notes.add("Textures not written.");
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

    /** Whole numbers up to 1 look like floats, and those up to 255 like levels of 8 bits. */
    private static boolean keepsType(Channel colour) {
        int largest = 0;
        for (int value : colour.values()) largest = Math.max(largest, value);
        return switch (colour.type()) {
            case FLOAT32 -> true;
            case UINT8 -> largest > 1;
            case UINT16 -> largest > 255;
            default -> false;
        };
    }

    private void vertex(TextOutput out, int v) throws IOException {
        int vertex = held.any() ? mesh.wedgeVertices()[v] : v;
        for (int axis = 0; axis < 3; axis++) {
            if (axis > 0) out.text(" ");
            if (mesh.isDouble()) out.text(FloatText.plain(mesh.coordinate(vertex, axis)));
            else out.number(mesh.positions()[3 * vertex + axis]);
        }
        if (held.normal() != null) out.floats(held.normal().values(), 3 * v, 3);
        if (held.colour() != null) colour(out, held.colour(), v);
        if (held.texcoord() != null) out.floats(held.texcoord().values(), 2 * v, 2);
        out.line();
    }

    private static void colour(TextOutput out, Channel colour, int wedge) throws IOException {
        int n = colour.components();
        for (int i = wedge * n; i < wedge * n + n; i++) {
            out.text(" ");
            if (!colour.type().isFloat()) {
                out.text(Long.toString((long) colour.exact(wedge, i - wedge * n)));
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
            float[] colour = DisplayMaterial.of(material, false).plain();
            int count = material.parameter("d") != null || colour[3] != 1 ? 4 : 3;
            for (int i = 0; i < count; i++) out.text(" ").decimal(colour[i]);
        }
        out.line();
    }
}
