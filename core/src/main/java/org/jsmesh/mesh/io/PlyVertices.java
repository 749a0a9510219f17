package org.jsmesh.mesh.io;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.Sizes;

/**
 * The element {@code vertex} of a PLY file: positions, normals, texture coordinates and colours. Other scalars become
 * channels under their names and of their types; lists are skipped and reported.
 */
final class PlyVertices {
    private static final String[] POSITION = {"x", "y", "z"};
    private static final String[] NORMAL = {"nx", "ny", "nz"};
    private static final String[][] TEXCOORD = {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}};

    private final PlyHeader.Element element;
    private final List<Note> notes;
    private final int[] positionColumns;
    private final Coordinates coordinates;
    private final SpoiltVertices spoilt = new SpoiltVertices();
    private final List<PlyColumns> attributes = new ArrayList<>();
    private final List<String> skipped = new ArrayList<>();

    PlyVertices(String file, PlyHeader.Element element, List<Note> notes) throws ModelFormatException {
        this.element = element;
        this.notes = notes;
        positionColumns = columns(POSITION);
        if (positionColumns == null)
            throw new ModelFormatException(
                    file, "", "element vertex has no x, y and z", "Give each vertex three coordinates");
        coordinates = new Coordinates(Sizes.of(3, element.count(), "vertices"));
        add(Channel.Semantic.NORMAL, "normal", columns(NORMAL), Channel.Type.FLOAT32);
        for (String[] names : TEXCOORD) {
            int[] found = columns(names);
            if (found == null) continue;
            add(Channel.Semantic.TEXCOORD, "uv", found, Channel.Type.FLOAT32);
            break;
        }
        PlyColourColumns colour = PlyColourColumns.of(element);
        if (colour.type() != null) add(Channel.Semantic.COLOUR, "colour", colour.columns(), colour.channelType());
        addScalars();
    }

    /** Null when one is missing or a list. */
    private int[] columns(String[] names) {
        int[] columns = new int[names.length];
        for (int i = 0; i < columns.length; i++) {
            columns[i] = element.indexOf(names[i]);
            if (columns[i] < 0 || element.properties().get(columns[i]).isList()) return null;
        }
        return columns;
    }

    private void add(Channel.Semantic semantic, String name, int[] columns, Channel.Type type) {
        if (columns != null)
            attributes.add(new PlyColumns(semantic, name, columns, type, !type.isFloat(), element.count()));
    }

    private void addScalars() {
        boolean[] known = new boolean[element.properties().size()];
        for (int column : positionColumns) known[column] = true;
        Set<String> names = new HashSet<>();
        for (PlyColumns attribute : attributes) {
            names.add(attribute.name());
            for (int column : attribute.columns()) known[column] = true;
        }
        for (int p = 0; p < known.length; p++) {
            PlyHeader.Property property = element.properties().get(p);
            if (known[p]) continue;
            boolean repeated = element.indexOf(property.name()) != p;
            if (property.isList() || repeated || !names.add(property.name())) skipped.add(property.name());
            else attributes.add(PlyColumns.scalar(property.name(), p, property.type(), element.count()));
        }
    }

    void read(PlyData data) throws ModelFormatException {
        List<PlyHeader.Property> properties = element.properties();
        PlyColumns[] attributeOf = new PlyColumns[properties.size()];
        int[] component = new int[properties.size()];
        int[] axis = new int[properties.size()];
        Arrays.fill(axis, -1);
        for (int i = 0; i < positionColumns.length; i++) axis[positionColumns[i]] = i;
        for (PlyColumns attribute : attributes) {
            for (int i = 0; i < attribute.columns().length; i++) {
                attributeOf[attribute.columns()[i]] = attribute;
                component[attribute.columns()[i]] = i;
            }
        }
        for (int vertex = 0; vertex < element.count(); vertex++) {
            for (int p = 0; p < attributeOf.length; p++) {
                if (axis[p] >= 0) {
                    readCoordinate(properties.get(p), vertex, axis[p], data);
                } else if (attributeOf[p] == null) {
                    PlyReader.skip(properties.get(p), data);
                } else {
                    attributeOf[p].set(
                            vertex, component[p], data.read(properties.get(p).type()));
                }
            }
        }
        for (PlyColumns attribute : attributes) {
            attribute.noteAbsent(notes);
            attribute.noteRounded(notes, "vertex");
        }
        if (!skipped.isEmpty())
            notes.add(Notes.unread("Vertex properties skipped: " + Notes.names(skipped) + ".", skipped));
    }

    private void readCoordinate(PlyHeader.Property property, int vertex, int axis, PlyData data)
            throws ModelFormatException {
        int index = 3 * vertex + axis;
        double value = data.readCoordinate(property.type(), index, coordinates);
        if (Float.isFinite((float) value)) return;
        coordinates.set(index, 0);
        spoilt.add(
                vertex,
                () -> data.error(
                        property.name() + " of vertex " + vertex + " is " + value + ", not a finite float32",
                        "Repair or remove this vertex in the program that wrote the file"));
    }

    SpoiltVertices spoilt() {
        return spoilt;
    }

    Coordinates positions() {
        return coordinates;
    }

    /** @param polygons whose corners name vertices */
    List<CornerAttribute> attributes(PolygonList polygons) {
        return attributes.stream().map(a -> a.ofCorners(polygons)).toList();
    }
}
