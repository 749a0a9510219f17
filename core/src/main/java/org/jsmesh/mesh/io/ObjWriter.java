package org.jsmesh.mesh.io;

import java.io.IOException;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;

/**
 * Writes OBJ with its material library. Corners without texture coordinates or normals leave them out: {@code v},
 * {@code v/vt}, {@code v//vn}, {@code v/vt/vn}. Vertex colours stand behind the coordinates; a vertex whose wedges
 * differ in colour is written once per colour. Colours of 8 bits also stand in lines {@code #MRGB}, which keep their
 * type.
 */
final class ObjWriter {
    private final Mesh mesh;
    private final List<String> notes;
    private final HeldChannels held;
    private final ObjGroupLines groups;

    ObjWriter(Mesh mesh, List<String> notes) {
        this.mesh = mesh;
        this.notes = notes;
        held = new HeldChannels(mesh, 3, "OBJ", notes);
        groups = new ObjGroupLines(mesh, notes);
        if (held.colour() == null || isPolypaint(held.colour())) return;
        if (held.colour().type() == Channel.Type.UINT8)
            notes.add("OBJ holds colours of 8 bits with opacity or gaps as numbers from 0 to 1.");
        else if (held.colour().type() != Channel.Type.FLOAT32)
            notes.add("OBJ holds colours of whole numbers of other types than 8 bits as floats.");
    }

    void write(String fileName, ResourceSink sink) throws IOException {
        String library = FileNames.stem(fileName) + ".mtl";
        MtlWriter materials = new MtlWriter(mesh.materials(), notes);
        try (TextOutput out = new TextOutput(sink.create(fileName))) {
            out.text("# written by jSM").line();
            if (!mesh.materials().isEmpty()) out.text("mtllib ").text(library).line();
            int[] vertices = writeVertices(out);
            int[] texcoords = writeRows(out, "vt", held.texcoord());
            int[] normals = writeRows(out, "vn", held.normal());
            writeFaces(out, vertices, texcoords, normals, materials);
        }
        if (mesh.materials().isEmpty()) {
            if (!mesh.textures().isEmpty()) notes.add("Textures that no material names not written.");
            return;
        }
        TextureFiles textures = new TextureFiles(List.of(fileName, library), notes);
        textures.write(mesh, sink);
        try (TextOutput out = new TextOutput(sink.create(library))) {
            materials.write(out, textures);
        }
    }

    private static boolean isPolypaint(Channel colour) {
        return colour.type() == Channel.Type.UINT8 && colour.components() == 3 && !colour.hasAbsent();
    }

    /** @return the line number, from 0, of each wedge's vertex */
    private int[] writeVertices(TextOutput out) throws IOException {
        Channel colour = held.colour();
        if (colour == null) {
            for (int v = 0; v < mesh.vertices(); v++)
                out.text("v").coordinates(mesh, v).line();
            return mesh.wedgeVertices();
        }
        int n = colour.components();
        TupleIndex written = new TupleIndex(n + 2);
        int[] lines = new int[mesh.wedges()];
        int[] key = new int[n + 2];
        IntList polypaint = new IntList();
        for (int w = 0; w < lines.length; w++) {
            key[0] = mesh.wedgeVertices()[w];
            key[1] = colour.isAbsent(w) ? 1 : 0;
            System.arraycopy(colour.values(), w * n, key, 2, n);
            int before = written.size();
            lines[w] = written.intern(key, 0);
            if (lines[w] < before) continue;
            out.text("v").coordinates(mesh, key[0]);
            for (int i = 0; i < n && !colour.isAbsent(w); i++) out.text(" ").number(colour.number(w, i));
            out.line();
            for (int i = 0; i < n; i++) polypaint.add(key[2 + i]);
        }
        if (isPolypaint(colour)) ObjPolypaint.write(out, polypaint.toArray());
        return lines;
    }

    /** @return the line number, from 0, of each wedge's row, −1 where it is absent; null without a channel */
    private static int[] writeRows(TextOutput out, String keyword, Channel channel) throws IOException {
        if (channel == null) return null;
        int n = channel.components();
        TupleIndex written = new TupleIndex(n);
        int[] lines = new int[channel.wedges()];
        for (int w = 0; w < lines.length; w++) {
            if (channel.isAbsent(w)) {
                lines[w] = -1;
                continue;
            }
            int before = written.size();
            lines[w] = written.intern(channel.values(), w * n);
            if (lines[w] == before)
                out.text(keyword).floats(channel.values(), w * n, n).line();
        }
        return lines;
    }

    private void writeFaces(TextOutput out, int[] vertices, int[] texcoords, int[] normals, MtlWriter materials)
            throws IOException {
        int current = -1;
        for (int face : groups.order(mesh)) {
            int material = mesh.faceMaterials()[face];
            if (material != current)
                out.text("usemtl ").text(materials.name(material)).line();
            current = material;
            writeFace(out, face, vertices, texcoords, normals);
        }
    }

    private void writeFace(TextOutput out, int face, int[] vertices, int[] texcoords, int[] normals)
            throws IOException {
        groups.before(face, out);
        out.text("f");
        for (int i = 0; i < 3; i++) {
            int wedge = mesh.faceWedges()[3 * face + i];
            int texcoord = texcoords == null ? -1 : texcoords[wedge];
            int normal = normals == null ? -1 : normals[wedge];
            out.text(" ").number(vertices[wedge] + 1);
            if (texcoord >= 0 || normal >= 0) out.text("/");
            if (texcoord >= 0) out.number(texcoord + 1);
            if (normal >= 0) out.text("/").number(normal + 1);
        }
        out.line();
    }
}
