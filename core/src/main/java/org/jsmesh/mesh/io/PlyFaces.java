package org.jsmesh.mesh.io;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Note;

/**
 * The elements {@code face} and {@code tristrips} of a PLY file. The list {@code texcoord} of faces is read too (two
 * floats per corner, with {@code texnumber} and {@code comment TextureFile}, as MeshLab writes them), and colours of
 * faces are. Other scalars of faces are kept under their names; lists are skipped and reported.
 */
final class PlyFaces {
    private static final List<String> INDEX_LISTS = List.of("vertex_indices", "vertex_index");

    private final int vertices;
    private final int textures;
    private final List<Note> notes;
    private final PolygonList polygons = new PolygonList();
    private final IntList texcoords = new IntList();
    private final IntList texcoordRows = new IntList();
    private final FaceColours colours;
    private final List<PlyColumns> kept = new ArrayList<>();
    private int firstScalars;
    private boolean numbered;
    private int badColours;
    private int firstBadColour;
    private int badTexcoords;
    private int notFinite;
    private int firstNotFinite;
    private int firstBadTexcoord;

    PlyFaces(int vertices, int textures, List<Note> notes) {
        this.vertices = vertices;
        this.textures = textures;
        colours = new FaceColours(notes);
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
        PlyColourColumns colour = PlyColourColumns.of(element);
        int[] component = new int[element.properties().size()];
        Arrays.fill(component, -1);
        for (int i = 0; i < colour.columns().length; i++) component[colour.columns()[i]] = i;
        PlyColumns[] scalars = scalars(element, component, indices, texcoord, texnumber);
        firstScalars = polygons.polygons();
        numbered = texnumber >= 0;
        float[] rgba = new float[4];
        polygons.expect(element.count());
        IntList uv = new IntList();
        for (int face = 0; face < element.count(); face++) {
            int first = polygons.corners();
            uv = uv.size() == 0 ? uv : new IntList();
            int number = numbered || textures == 0 ? -1 : 0;
            boolean finite = true;
            for (int p = 0; p < element.properties().size(); p++) {
                PlyHeader.Property property = element.properties().get(p);
                if (p == indices) {
                    int count = data.readCount(property);
                    for (int i = 0; i < count; i++)
                        polygons.corner(index(data.read(property.type()), "face", face, data));
                } else if (p == texcoord) {
                    int count = data.readCount(property);
                    for (int i = 0; i < count; i++) uv.add(Float.floatToRawIntBits((float) data.read(property.type())));
                } else if (p == texnumber) {
                    number = (int) data.read(property.type());
                    if (number >= textures) number = -1;
                } else if (component[p] >= 0) {
                    rgba[component[p]] = (float) data.read(property.type());
                    finite &= Float.isFinite(rgba[component[p]]);
                } else if (scalars[p] != null) {
                    scalars[p].set(face, 0, data.read(property.type()));
                } else {
                    PlyReader.skip(property, data);
                }
            }
            if (!finite && badColours++ == 0) firstBadColour = face;
            polygons.end(colours.add(number, colour.range(), finite ? colour.columns().length : 0, rgba));
            if (texcoord >= 0) keep(uv, first, polygons.corners() - first);
        }
        for (PlyColumns scalar : kept) scalar.noteRounded(notes, "face");
    }

    /** Columns for scalars of other meaning. Lists and repeated names are told. */
    private PlyColumns[] scalars(PlyHeader.Element element, int[] component, int... used) {
        PlyColumns[] scalars = new PlyColumns[component.length];
        List<String> skipped = new ArrayList<>();
        for (int p = 0; p < component.length; p++) {
            PlyHeader.Property property = element.properties().get(p);
            boolean known = component[p] >= 0;
            for (int u : used) known |= u == p;
            if (known) continue;
            if (property.isList() || element.indexOf(property.name()) != p) {
                skipped.add(property.name());
            } else {
                scalars[p] = PlyColumns.scalar(property.name(), p, property.type(), element.count());
                kept.add(scalars[p]);
            }
        }
        noteSkipped(element, skipped);
        return scalars;
    }

    private void noteSkipped(PlyHeader.Element element, List<String> skipped) {
        if (!skipped.isEmpty())
            notes.add(Notes.unread(
                    "Properties of " + element.name() + " skipped: " + Notes.names(skipped) + ".", skipped));
    }

    private static boolean isFinite(int bits) {
        return Float.isFinite(Float.intBitsToFloat(bits));
    }

    private void keep(IntList uv, int first, int corners) {
        while (texcoordRows.size() < first) texcoordRows.add(-1);
        boolean fits = uv.size() == 2 * corners;
        if (!fits && uv.size() > 0 && badTexcoords++ == 0) firstBadTexcoord = polygons.polygons() - 1;
        for (int i = 0; i < corners; i++) {
            boolean given = fits && isFinite(uv.get(2 * i)) && isFinite(uv.get(2 * i + 1));
            if (fits && !given && notFinite++ == 0) firstNotFinite = polygons.polygons() - 1;
            texcoordRows.add(given ? texcoords.size() / 2 : -1);
            if (given) {
                texcoords.add(uv.get(2 * i));
                texcoords.add(uv.get(2 * i + 1));
            }
        }
    }

    void readStrips(PlyHeader.Element element, PlyData data) throws ModelFormatException {
        int indices = indexList(element, data);
        List<String> skipped = new ArrayList<>();
        for (PlyHeader.Property property : element.properties()) skipped.add(property.name());
        skipped.remove(indices);
        noteSkipped(element, skipped);
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

    /** Texture coordinates of the corners of faces, or null. */
    CornerAttribute cornerTexcoords(String name) {
        if (badTexcoords > 0)
            notes.add(Note.dropped(
                            "Texture coordinates of " + Notes.count(badTexcoords, "face")
                                    + " left out: not two per corner.",
                            badTexcoords,
                            "face " + firstBadTexcoord)
                    .asWarning());
        Notes.leftOut(notes, "texture coordinates", notFinite, "corner of a face", "face " + firstNotFinite);
        if (texcoords.size() == 0) return null;
        while (texcoordRows.size() < polygons.corners()) texcoordRows.add(-1);
        return new CornerAttribute(
                Channel.Semantic.TEXCOORD, name, 2, Channel.Type.FLOAT32, texcoords.toArray(), texcoordRows.toArray());
    }

    /** Faces choose a texture file by {@code texnumber}, or take the first, and have a colour of their own. */
    void materials(
            MeshAssembler assembler, int[] ids, List<String> files, ResourceResolver resources, String colourChannel)
            throws IOException {
        Notes.leftOut(notes, "colour", badColours, "face", "face " + firstBadColour);
        colours.assign(assembler, polygons, ids, files, new TextureLoader(resources, notes), colourChannel);
    }

    void scalars(MeshAssembler assembler, int[] polygonOfTriangle) {
        for (PlyColumns scalar : kept) assembler.faceChannel(scalar.ofFaces(firstScalars, polygonOfTriangle));
    }
}
