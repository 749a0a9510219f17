package org.jsmesh.mesh.io;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.Texture;

/**
 * The elements {@code face} and {@code tristrips} of a PLY file. The list {@code texcoord} of faces is read too (two
 * floats per corner, with {@code texnumber} and {@code comment TextureFile}, as MeshLab writes them). Other properties
 * are skipped and reported.
 */
final class PlyFaces {
    private static final List<String> INDEX_LISTS = List.of("vertex_indices", "vertex_index");

    private final int vertices;
    private final List<Note> notes;
    private final PolygonList polygons = new PolygonList();
    private final IntList texcoords = new IntList();
    private final IntList texcoordRows = new IntList();
    private boolean numbered;
    private int badTexcoords;
    private int firstBadTexcoord;

    PlyFaces(int vertices, List<Note> notes) {
        this.vertices = vertices;
        this.notes = notes;
    }

    PolygonList polygons() {
        return polygons;
    }

    void readFaces(PlyHeader.Element element, PlyData data) throws ModelFormatException {
        int indices = indexList(element, data);
        int texcoord = element.indexOf("texcoord");
        if (texcoord >= 0 && !element.properties().get(texcoord).isList()) texcoord = -1;
        int texnumber = element.indexOf("texnumber");
        if (texnumber >= 0 && element.properties().get(texnumber).isList()) texnumber = -1;
        noteSkipped(element, indices, texcoord, texnumber);
        numbered = texnumber >= 0;
        polygons.expect(element.count());
        IntList uv = new IntList();
        for (int face = 0; face < element.count(); face++) {
            int first = polygons.corners();
            uv = uv.size() == 0 ? uv : new IntList();
            int number = -1;
            for (int p = 0; p < element.properties().size(); p++) {
                PlyHeader.Property property = element.properties().get(p);
                if (p == indices) {
                    int count = data.readCount(property);
                    for (int i = 0; i < count; i++)
                        polygons.corner(index(data.read(property.type()), "face", face, data));
                } else if (p == texcoord) {
                    int count = data.readCount(property);
                    for (int i = 0; i < count; i++) uv.add(texcoord(data.read(property.type()), face, data));
                } else if (p == texnumber) {
                    number = (int) data.read(property.type());
                } else {
                    PlyReader.skip(property, data);
                }
            }
            polygons.end(number);
            if (texcoord >= 0) keep(uv, first, polygons.corners() - first);
        }
    }

    private void keep(IntList uv, int first, int corners) {
        while (texcoordRows.size() < first) texcoordRows.add(-1);
        boolean fits = uv.size() == 2 * corners;
        if (!fits && uv.size() > 0 && badTexcoords++ == 0) firstBadTexcoord = polygons.polygons() - 1;
        for (int i = 0; i < corners; i++) {
            texcoordRows.add(fits ? texcoords.size() / 2 : -1);
            if (fits) {
                texcoords.add(uv.get(2 * i));
                texcoords.add(uv.get(2 * i + 1));
            }
        }
    }

    private static int texcoord(double value, int face, PlyData data) throws ModelFormatException {
        float rounded = (float) value;
        if (Float.isNaN(rounded) || Float.isInfinite(rounded)) {
            throw data.error(
                    "texcoord of face " + face + " is " + value + ", not a finite float32",
                    "Repair the texture coordinates of this face");
        }
        return Float.floatToRawIntBits(rounded);
    }

    void readStrips(PlyHeader.Element element, PlyData data) throws ModelFormatException {
        int indices = indexList(element, data);
        noteSkipped(element, indices, -1, -1);
        TriangleStrip strip = new TriangleStrip(polygons);
        for (int row = 0; row < element.count(); row++) {
            for (int p = 0; p < element.properties().size(); p++) {
                PlyHeader.Property property = element.properties().get(p);
                if (p != indices) {
                    PlyReader.skip(property, data);
                    continue;
                }
                int count = data.readCount(property);
                for (int i = 0; i < count; i++) {
                    double value = data.read(property.type());
                    strip.add(value == -1 ? -1 : index(value, "strip", row, data));
                }
                strip.add(-1);
            }
        }
        if (strip.dropped() > 0)
            notes.add(Note.repaired(
                    Notes.count(strip.dropped(), "degenerate triangle") + " that stitch strips dropped.",
                    strip.dropped(),
                    ""));
    }

    private static int indexList(PlyHeader.Element element, PlyData data) throws ModelFormatException {
        for (String name : INDEX_LISTS) {
            int index = element.indexOf(name);
            if (index >= 0 && element.properties().get(index).isList()) return index;
        }
        throw data.error(
                "element " + element.name() + " has no list vertex_indices", "Name the list of corners vertex_indices");
    }

    private int index(double value, String element, int row, PlyData data) throws ModelFormatException {
        int vertex = (int) value;
        if (vertex == value && vertex >= 0 && vertex < vertices) return vertex;
        String shown = value == Math.rint(value) ? String.valueOf((long) value) : String.valueOf(value);
        throw data.error(
                element + " " + row + " names vertex " + shown + " of " + vertices, "Repair or remove this face");
    }

    private void noteSkipped(PlyHeader.Element element, int... used) {
        List<String> skipped = new ArrayList<>();
        for (int p = 0; p < element.properties().size(); p++) {
            boolean known = false;
            for (int u : used) known |= u == p;
            if (!known) skipped.add(element.properties().get(p).name());
        }
        if (!skipped.isEmpty())
            notes.add(Notes.unread(
                    "Properties of " + element.name() + " skipped: " + Notes.names(skipped) + ".", skipped));
    }

    /** Texture coordinates of the corners of faces, or null. */
    CornerAttribute cornerTexcoords(String name) {
        if (badTexcoords > 0)
            notes.add(Note.dropped(
                    "Texture coordinates of " + Notes.count(badTexcoords, "face") + " left out: not two per corner.",
                    badTexcoords,
                    "face " + firstBadTexcoord));
        if (texcoords.size() == 0) return null;
        while (texcoordRows.size() < polygons.corners()) texcoordRows.add(-1);
        return new CornerAttribute(
                Channel.Semantic.TEXCOORD, name, 2, Channel.Type.FLOAT32, texcoords.toArray(), texcoordRows.toArray());
    }

    /** One material per texture file; faces choose by {@code texnumber}, or take the first. */
    void materials(MeshAssembler assembler, int[] numbers, List<String> files, ResourceResolver resources)
            throws IOException {
        if (files.isEmpty()) return;
        List<Material> materials = new ArrayList<>();
        for (String path : files) {
            materials.add(new Material(path, List.of(), List.of(new Material.TextureReference("map_Kd", path))));
        }
        int[] ids = new int[numbers.length];
        for (int f = 0; f < ids.length; f++) {
            int number = numbered ? numbers[f] : 0;
            ids[f] = number >= 0 && number < files.size() ? number : -1;
        }
        List<Texture> textures = new TextureLoader(resources, notes).load(materials);
        assembler.materials(ids, materials, textures);
    }
}
