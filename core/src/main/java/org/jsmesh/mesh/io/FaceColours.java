package org.jsmesh.mesh.io;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Note;

/**
 * The colours that faces of a file have. Few colours become a material each, so that faces of one colour stay one part.
 * Many, as in a scan, become colours of the corners. A face may name a texture beside its colour.
 */
final class FaceColours {
    /** More colours than this are no parts of a thing but a picture on it. */
    static final int MOST_MATERIALS = 1024;

    /** What the numbers of a colour count up to. */
    enum Range {
        BYTE,
        SHORT,
        /** Whole numbers: to 255, or to 65535 when one is larger. */
        WHOLE,
        /** Decimals: to 1, or to 255 when one is larger. */
        DECIMAL,
        /** Whole numbers of a text: to 255, or to 1 when none is larger. */
        TEXT
    }

    private static final int TEXTURE = 0;
    private static final int RANGE = 1;
    private static final int COMPONENTS = 2;
    private static final int VALUES = 3;

    private final TupleIndex rows = new TupleIndex(VALUES + 4);
    private final float[] largest = new float[Range.values().length];
    private final List<Note> notes;
    private boolean alpha;
    private boolean coloured;

    FaceColours(List<Note> notes) {
        this.notes = notes;
    }

    /**
     * @param texture number of a texture, or −1
     * @param components 0 for a face without a colour, else 3 or 4
     * @param rgba values as the file has them, finite
     * @return what {@link PolygonList#end} takes; −1 for neither a texture nor a colour
     */
    int add(int texture, Range range, int components, float[] rgba) {
        if (texture < 0 && components == 0) return -1;
        int[] row = new int[VALUES + 4];
        row[TEXTURE] = texture;
        row[RANGE] = range.ordinal();
        row[COMPONENTS] = components;
        for (int i = 0; i < components; i++) {
            row[VALUES + i] = Float.floatToRawIntBits(rgba[i]);
            largest[range.ordinal()] = Math.max(largest[range.ordinal()], rgba[i]);
        }
        alpha |= components == 4;
        coloured |= components > 0;
        return rows.intern(row, 0);
    }

    private float scale(int row) {
        Range range = Range.values()[rows.value(row, RANGE)];
        float most = largest[range.ordinal()];
        return switch (range) {
            case WHOLE -> most > 255 ? 65535 : 255;
            case DECIMAL, TEXT -> most > 1 ? 255 : 1;
            case BYTE -> 255;
            case SHORT -> 65535;
        };
    }

    private float[] colour(int row) {
        float[] colour = new float[rows.value(row, COMPONENTS)];
        float scale = scale(row);
        for (int i = 0; i < colour.length; i++) colour[i] = Float.intBitsToFloat(rows.value(row, VALUES + i)) / scale;
        return colour;
    }

    /**
     * Gives the assembler the materials of the triangles, and colours of corners when there are many colours.
     *
     * @param ids of each triangle, as {@link #add} gave them
     * @param textureFiles that textures are numbers of
     * @param images loads them
     * @param name of the channel that many colours become
     */
    void assign(
            MeshAssembler assembler,
            PolygonList polygons,
            int[] ids,
            List<String> textureFiles,
            TextureLoader images,
            String name)
            throws IOException {
        boolean many = rows.size() > MOST_MATERIALS;
        if (coloured && !many) {
            ofFaces(assembler, ids, textureFiles, images);
        } else if (!textureFiles.isEmpty()) {
            int[] triangles = new int[ids.length];
            for (int f = 0; f < ids.length; f++) triangles[f] = ids[f] < 0 ? -1 : rows.value(ids[f], TEXTURE);
            List<Material> materials =
                    textureFiles.stream().map(path -> textured(path, List.of())).toList();
            assembler.materials(triangles, materials, images.load(materials));
        }
        if (coloured && many) {
            assembler.attribute(ofCorners(polygons, name));
            String text = Notes.count(rows.size(), "colour") + " of faces kept as colours of their corners.";
            notes.add(Note.changed(text, rows.size(), ""));
        }
    }

    /** The same for faces without textures. */
    void assign(MeshAssembler assembler, PolygonList polygons, int[] ids, String name) {
        try {
            assign(assembler, polygons, ids, List.of(), new TextureLoader(ResourceResolver.NONE, notes), name);
        } catch (IOException e) {
            throw new AssertionError("there is nothing to load", e);
        }
    }

    private void ofFaces(MeshAssembler assembler, int[] ids, List<String> textureFiles, TextureLoader images)
            throws IOException {
        List<Material> all = new ArrayList<>();
        Map<Material, Integer> numbers = new HashMap<>();
        int[] numberOf = new int[rows.size()];
        for (int row = 0; row < numberOf.length; row++) {
            numberOf[row] = numbers.computeIfAbsent(material(row, textureFiles), m -> {
                all.add(m);
                return all.size() - 1;
            });
        }
        int[] triangles = new int[ids.length];
        for (int f = 0; f < triangles.length; f++) triangles[f] = ids[f] < 0 ? -1 : numberOf[ids[f]];
        MaterialUse use = new MaterialUse(triangles, all);
        assembler.materials(use.faceMaterials(), use.materials(), images.load(use.materials()));
    }

    private Material material(int row, List<String> textureFiles) {
        int texture = rows.value(row, TEXTURE);
        float[] colour = colour(row);
        List<Material.Parameter> parameters = new ArrayList<>();
        if (colour.length > 0) parameters.add(new Material.Parameter("rgb", colour[0], colour[1], colour[2]));
        if (colour.length > 3) parameters.add(new Material.Parameter("d", colour[3]));
        if (texture >= 0) return textured(textureFiles.get(texture), parameters);
        return new Material(FaceColour.name(parameters.get(0).values()), parameters, List.of());
    }

    private static Material textured(String path, List<Material.Parameter> parameters) {
        return new Material(path, parameters, List.of(new Material.TextureReference("map_Kd", path)));
    }

    private CornerAttribute ofCorners(PolygonList polygons, String name) {
        int components = alpha ? 4 : 3;
        boolean bytes = true;
        for (int row = 0; row < rows.size(); row++) bytes &= scale(row) == 255;
        int[] values = new int[rows.size() * components];
        for (int row = 0; row < rows.size(); row++) {
            float[] colour = colour(row);
            for (int i = 0; i < components; i++) {
                float value = i < colour.length ? colour[i] : 1;
                values[row * components + i] = bytes ? Math.round(255 * value) : Float.floatToRawIntBits(value);
            }
        }
        int[] corners = new int[polygons.corners()];
        for (int polygon = 0; polygon < polygons.polygons(); polygon++) {
            int row = polygons.material(polygon);
            boolean has = row >= 0 && rows.value(row, COMPONENTS) > 0;
            Arrays.fill(corners, polygons.firstCorner(polygon), polygons.endCorner(polygon), has ? row : -1);
        }
        Channel.Type type = bytes ? Channel.Type.UINT8 : Channel.Type.FLOAT32;
        return new CornerAttribute(Channel.Semantic.COLOUR, name, components, type, values, corners);
    }
}
