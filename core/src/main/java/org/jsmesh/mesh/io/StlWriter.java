package org.jsmesh.mesh.io;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;

/** Writes binary STL: positions, with the normal of each facet, and colours as VisCAM or Magics write them. */
final class StlWriter {
    private static final String TITLE = "binary STL written by jSM ";

    private final Mesh mesh;
    private final boolean coloured;
    private final boolean common;
    private final FaceChannel attribute; // or null

    StlWriter(Mesh mesh, List<String> notes) {
        this.mesh = mesh;
        List<String> channels = mesh.channels().stream().map(Channel::name).toList();
        if (!channels.isEmpty()) notes.add("STL does not hold these channels: " + Notes.names(channels) + ".");
        if (mesh.isDouble()) notes.add("STL holds float32 alone: positions are written as " + offsets(mesh) + ".");
        FaceChannel found = null;
        List<String> lost = new ArrayList<>();
        for (FaceChannel channel : mesh.faceChannels()) {
            boolean isAttribute = channel.name().equals(StlReader.ATTRIBUTE)
                    && channel.components() == 1
                    && channel.type() == Channel.Type.UINT16;
            if (isAttribute && mesh.materials().isEmpty()) found = channel;
            else lost.add(channel.name());
        }
        attribute = found;
        if (!lost.isEmpty()) notes.add("STL does not hold these attributes of faces: " + Notes.names(lost) + ".");
        coloured = !mesh.materials().isEmpty() && mesh.materials().stream().allMatch(FaceColour::is);
        common = coloured && isOneColour();
        if (!coloured && !mesh.materials().isEmpty()) notes.add("STL does not hold materials and textures.");
        if (coloured && !common && !mesh.materials().stream().allMatch(StlWriter::isExact))
            notes.add("STL holds colours of 5 bits without opacity: they are rounded.");
    }

    private static String offsets(Mesh mesh) {
        double[] from = mesh.origin();
        if (from[0] == 0 && from[1] == 0 && from[2] == 0) return "the closest float32";
        StringBuilder text = new StringBuilder("offsets from");
        for (double x : from) text.append(' ').append(FloatText.plain(x));
        return text.toString();
    }

    /** Opacity and colours of 8 bits have room in the header alone, for all faces. */
    private boolean isOneColour() {
        for (int id : mesh.faceMaterials()) if (id != 0) return false;
        if (isExact(mesh.materials().get(0))) return false;
        float[] opacity = mesh.materials().get(0).parameter("d");
        if (opacity != null && opacity[0] == 1) return false;
        for (float value : DisplayMaterial.of(mesh.materials().get(0), false).plain()) {
            if (!FaceColour.isPart(value, 255)) return false;
        }
        return true;
    }

    private static boolean isExact(Material material) {
        return material.parameter("d") == null && StlColours.isExact(material.parameter("rgb"));
    }

    void write(String fileName, ResourceSink sink) throws IOException {
        try (LittleEndianOutput out = new LittleEndianOutput(sink.create(fileName))) {
            byte[] header = Arrays.copyOf(TITLE.trim().getBytes(StandardCharsets.US_ASCII), StlReader.HEADER_BYTES);
            if (common)
                StlColours.write(
                        header,
                        TITLE.length(),
                        DisplayMaterial.of(mesh.materials().get(0), false).plain());
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
        int id = mesh.faceMaterials()[face];
        boolean own = coloured && !common && id >= 0;
        if (attribute != null) out.writeShort(attribute.values()[face]);
        else out.writeShort(own ? StlColours.word(mesh.materials().get(id).parameter("rgb")) : 0);
    }
}
