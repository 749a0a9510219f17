package org.jsmesh.mesh.io;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;

/**
 * Writes Hoppe's {@code .m}. The attributes of a vertex with one wedge are in its line, those of other vertices are per
 * corner. A material has its name and its colour written.
 */
final class HoppeWriter {
    private final Mesh mesh;
    private final HeldChannels held;
    private final int[] wedgesOfVertex;
    private final int[] firstWedge;
    private final List<String> materialTexts = new ArrayList<>();

    HoppeWriter(Mesh mesh, List<String> notes) {
        this.mesh = mesh;
        held = new HeldChannels(mesh, 2, ".m", notes);
        List<String> ofFaces =
                mesh.faceChannels().stream().map(FaceChannel::name).toList();
        if (!ofFaces.isEmpty()) notes.add(".m does not hold these attributes of faces: " + Notes.names(ofFaces) + ".");
        if (held.colour() != null && !held.colour().type().isFloat())
            notes.add(".m holds colours of whole numbers as decimals.");
        if (held.colour() != null && held.colour().components() > 3)
            notes.add(".m does not hold the alpha of colours.");
        boolean lossy = false;
        for (Material material : mesh.materials()) {
            String text = text(material);
            lossy |= !isHeld(material) || materialTexts.contains(text);
            materialTexts.add(text);
        }
        if (lossy) notes.add(".m holds only the names and colours of materials.");
        if (!mesh.textures().isEmpty()) notes.add("Textures not written.");
        if (held.any() && hasFaceWithTwoWedgesOfOneVertex())
            notes.add(".m cannot tell the corners of a face apart that name the same vertex.");
        wedgesOfVertex = new int[mesh.vertices()];
        firstWedge = new int[mesh.vertices()];
        for (int w = mesh.wedges() - 1; w >= 0; w--) {
            wedgesOfVertex[mesh.wedgeVertices()[w]]++;
            firstWedge[mesh.wedgeVertices()[w]] = w;
        }
    }

    private boolean hasFaceWithTwoWedgesOfOneVertex() {
        for (int f = 0; f < mesh.faces(); f++) {
            for (int i = 0; i < 3; i++) {
                int j = (i + 1) % 3;
                boolean otherWedge = mesh.faceWedges()[3 * f + i] != mesh.faceWedges()[3 * f + j];
                if (otherWedge && mesh.vertex(f, i) == mesh.vertex(f, j)) return true;
            }
        }
        return false;
    }

    private static boolean isHeld(Material material) {
        float[] rgb = material.parameter("rgb");
        boolean onlyColour =
                material.parameters().isEmpty() || material.parameters().size() == 1 && rgb != null && rgb.length == 3;
        return onlyColour
                && material.textures().isEmpty()
                && !material.isGltf()
                && clean(material.name()).equals(material.name());
    }

    private static String text(Material material) {
        float[] own = material.parameter("rgb");
        boolean coloured =
                own != null && own.length == 3 || !material.parameters().isEmpty() || material.isGltf();
        float[] rgb = own != null && own.length == 3
                ? own
                : DisplayMaterial.of(material, false).plain();
        String colour = FaceColour.text(new float[] {rgb[0], rgb[1], rgb[2]});
        String name = clean(material.name());
        List<String> parts = new ArrayList<>();
        if (name.matches("matid=[^ {}\"()]+")) {
            parts.add(name);
        } else if (!coloured || !name.equals("rgb=" + colour)) {
            parts.add("mat=\"" + name + '"');
        }
        if (coloured) parts.add("rgb=" + colour);
        return " {" + String.join(" ", parts) + '}';
    }

    private static String clean(String name) {
        return name.replaceAll("[\\p{Cntrl}\"]", "_");
    }

    void write(String fileName, ResourceSink sink) throws IOException {
        try (TextOutput out = new TextOutput(sink.create(fileName))) {
            for (int v = 0; v < mesh.vertices(); v++) {
                out.text("Vertex ").number(v + 1).coordinates(mesh, v);
                if (wedgesOfVertex[v] == 1) out.text(attributes(firstWedge[v]));
                out.line();
            }
            for (int f = 0; f < mesh.faces(); f++) {
                out.text("Face ").number(f + 1);
                for (int i = 0; i < 3; i++) out.text(" ").number(mesh.vertex(f, i) + 1);
                if (mesh.faceMaterials()[f] >= 0) out.text(materialTexts.get(mesh.faceMaterials()[f]));
                out.line();
            }
            if (held.any()) corners(out);
        }
    }

    private void corners(TextOutput out) throws IOException {
        for (int c = 0; c < mesh.faceWedges().length; c++) {
            int wedge = mesh.faceWedges()[c];
            int vertex = mesh.wedgeVertices()[wedge];
            String attributes = wedgesOfVertex[vertex] > 1 ? attributes(wedge) : "";
            if (attributes.isEmpty()) continue;
            out.text("Corner ")
                    .number(vertex + 1)
                    .text(" ")
                    .number(c / 3 + 1)
                    .text(attributes)
                    .line();
        }
    }

    private String attributes(int wedge) {
        List<String> parts = new ArrayList<>();
        add(parts, "normal", held.normal(), 3, wedge);
        add(parts, "uv", held.texcoord(), 2, wedge);
        add(parts, "rgb", held.colour(), 3, wedge);
        return parts.isEmpty() ? "" : " {" + String.join(" ", parts) + '}';
    }

    private static void add(List<String> parts, String key, Channel channel, int count, int wedge) {
        if (channel == null || channel.isAbsent(wedge)) return;
        float[] values = new float[count];
        for (int i = 0; i < count; i++) values[i] = channel.number(wedge, i);
        parts.add(key + '=' + FaceColour.text(values));
    }
}
