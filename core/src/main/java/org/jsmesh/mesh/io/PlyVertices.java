package org.jsmesh.mesh.io;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Note;

/**
 * The element {@code vertex} of a PLY file: positions, normals, texture coordinates and colours; other properties are
 * skipped and reported.
 */
final class PlyVertices {
    private static final String[] POSITION = {"x", "y", "z"};
    private static final String[] NORMAL = {"nx", "ny", "nz"};
    private static final String[][] TEXCOORD = {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}};
    private static final String[][] COLOUR = {
        {"red", "green", "blue", "alpha"},
        {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"},
        {"r", "g", "b", "a"}
    };

    /** Properties that make one channel; {@code values} are raw as in {@link Channel}. */
    private static final class Group {
        final Channel.Semantic semantic;
        final String name;
        final int[] columns;
        final Channel.Type type;
        final int[] values;
        int rounded;
        int firstRounded;

        Group(Channel.Semantic semantic, String name, int[] columns, Channel.Type type, int vertices) {
            this.semantic = semantic;
            this.name = name;
            this.columns = columns;
            this.type = type;
            values = new int[columns.length * vertices];
        }
    }

    private final String file;
    private final PlyHeader.Element element;
    private final List<Note> notes;
    private final Group positions;
    private final List<Group> groups = new ArrayList<>();

    PlyVertices(String file, PlyHeader.Element element, List<Note> notes) throws ModelFormatException {
        this.file = file;
        this.element = element;
        this.notes = notes;
        positions = group(null, "position", POSITION);
        if (positions == null)
            throw new ModelFormatException(
                    file, "", "element vertex has no x, y and z", "Give each vertex three coordinates");
        groups.add(positions);
        add(group(Channel.Semantic.NORMAL, "normal", NORMAL));
        add(Arrays.stream(TEXCOORD)
                .map(n -> group(Channel.Semantic.TEXCOORD, "uv", n))
                .filter(g -> g != null)
                .findFirst()
                .orElse(null));
        add(Arrays.stream(COLOUR)
                .map(this::colour)
                .filter(g -> g != null)
                .findFirst()
                .orElse(null));
    }

    private void add(Group group) {
        if (group != null) groups.add(group);
    }

    private Group group(Channel.Semantic semantic, String name, String[] properties) {
        int[] columns = new int[properties.length];
        for (int i = 0; i < columns.length; i++) {
            columns[i] = element.indexOf(properties[i]);
            if (columns[i] < 0 || element.properties().get(columns[i]).isList()) return null;
        }
        return new Group(semantic, name, columns, Channel.Type.FLOAT32, element.count());
    }

    private Group colour(String[] names) {
        Group opaque = group(Channel.Semantic.COLOUR, "colour", Arrays.copyOf(names, 3));
        if (opaque == null) return null;
        PlyType type = type(opaque.columns[0]);
        boolean bytes = type == PlyType.UCHAR;
        if (!bytes && type.isInteger()) return null;
        for (int column : opaque.columns) {
            if ((type(column) == PlyType.UCHAR) != bytes || type(column).isInteger() != bytes) return null;
        }
        Group all = group(Channel.Semantic.COLOUR, "colour", names);
        boolean alpha = all != null
                && (type(all.columns[3]) == PlyType.UCHAR) == bytes
                && type(all.columns[3]).isInteger() == bytes;
        int[] columns = alpha ? all.columns : opaque.columns;
        return new Group(
                Channel.Semantic.COLOUR,
                "colour",
                columns,
                bytes ? Channel.Type.UINT8 : Channel.Type.FLOAT32,
                element.count());
    }

    private PlyType type(int column) {
        return element.properties().get(column).type();
    }

    void read(PlyData data) throws ModelFormatException {
        List<PlyHeader.Property> properties = element.properties();
        Group[] groupOf = new Group[properties.size()];
        int[] component = new int[properties.size()];
        for (Group group : groups) {
            for (int i = 0; i < group.columns.length; i++) {
                groupOf[group.columns[i]] = group;
                component[group.columns[i]] = i;
            }
        }
        List<String> skipped = new ArrayList<>();
        for (int p = 0; p < groupOf.length; p++) {
            if (groupOf[p] == null) skipped.add(properties.get(p).name());
        }
        for (int vertex = 0; vertex < element.count(); vertex++) {
            for (int p = 0; p < groupOf.length; p++) {
                Group group = groupOf[p];
                if (group == null) {
                    PlyReader.skip(properties.get(p), data);
                } else {
                    group.values[vertex * group.columns.length + component[p]] =
                            raw(group, properties.get(p), vertex, data);
                }
            }
        }
        for (Group group : groups) {
            if (group.rounded == 0) continue;
            String text = Notes.count(group.rounded, group.name + " value") + " rounded to float32.";
            notes.add(Note.changed(text, group.rounded, "vertex " + group.firstRounded));
        }
        if (!skipped.isEmpty())
            notes.add(Notes.unread("Vertex properties skipped: " + Notes.names(skipped) + ".", skipped));
    }

    private static int raw(Group group, PlyHeader.Property property, int vertex, PlyData data)
            throws ModelFormatException {
        double value = data.read(property.type());
        if (group.type == Channel.Type.UINT8) return (int) value;
        float rounded = (float) value;
        if (Float.isNaN(rounded) || Float.isInfinite(rounded)) {
            throw data.error(
                    property.name() + " of vertex " + vertex + " is " + value + ", not a finite float32",
                    "Repair or remove this vertex in the program that wrote the file");
        }
        if (rounded != value && group.rounded++ == 0) group.firstRounded = vertex;
        return Float.floatToRawIntBits(rounded);
    }

    float[] positions() {
        float[] xyz = new float[positions.values.length];
        for (int i = 0; i < xyz.length; i++) xyz[i] = Float.intBitsToFloat(positions.values[i]);
        return xyz;
    }

    List<CornerAttribute> attributes() {
        List<CornerAttribute> list = new ArrayList<>();
        for (Group g : groups) {
            if (g != positions)
                list.add(new CornerAttribute(g.semantic, g.name, g.columns.length, g.type, g.values, null));
        }
        return list;
    }
}
