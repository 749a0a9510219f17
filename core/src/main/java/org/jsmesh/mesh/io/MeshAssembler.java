package org.jsmesh.mesh.io;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.Sizes;
import org.jsmesh.mesh.Texture;

/**
 * Makes a mesh from corners that name a vertex and rows of attribute tables. Corners of a vertex that agree in the bits
 * of all attributes become one wedge. Wedges are numbered by vertex, then by first use. Attributes that no corner has
 * are left out.
 */
public final class MeshAssembler {
    private final float[] positions; // or null
    private final double[] exactPositions; // or null
    private final int[] cornerVertices;
    private final int[] faceCorners;
    private final List<CornerAttribute> attributes = new ArrayList<>();
    private int[] faceMaterials;
    private List<Material> materials = List.of();
    private List<Texture> textures = List.of();
    private final List<FaceChannel> faceChannels = new ArrayList<>();
    private boolean weld;

    /**
     * @param positions x, y, z per vertex
     * @param cornerVertices the vertex of each corner
     * @param faceCorners three corners per triangle
     */
    public MeshAssembler(float[] positions, int[] cornerVertices, int[] faceCorners) {
        this(positions, null, cornerVertices, faceCorners);
    }

    /**
     * Takes positions in double precision. They make a mesh of float32 where that holds all of them.
     *
     * @param positions x, y, z per vertex
     * @param cornerVertices the vertex of each corner
     * @param faceCorners three corners per triangle
     */
    public MeshAssembler(double[] positions, int[] cornerVertices, int[] faceCorners) {
        this(null, positions, cornerVertices, faceCorners);
    }

    private MeshAssembler(float[] positions, double[] exactPositions, int[] cornerVertices, int[] faceCorners) {
        this.positions = positions;
        this.exactPositions = exactPositions;
        this.cornerVertices = cornerVertices;
        this.faceCorners = faceCorners;
    }

    /**
     * Adds an attribute.
     *
     * @param attribute its table, and the row of each corner
     * @return this
     */
    public MeshAssembler attribute(CornerAttribute attribute) {
        attributes.add(attribute);
        return this;
    }

    /**
     * Adds an attribute of the faces.
     *
     * @param channel with a value for each triangle
     * @return this
     */
    public MeshAssembler faceChannel(FaceChannel channel) {
        faceChannels.add(channel);
        return this;
    }

    /**
     * Sets the materials.
     *
     * @param ids material of each triangle, −1 for none
     * @param definitions the materials that ids number from 0
     * @param images the files that they refer to
     * @return this
     */
    public MeshAssembler materials(int[] ids, List<Material> definitions, List<Texture> images) {
        faceMaterials = ids;
        materials = definitions;
        textures = images;
        return this;
    }

    /**
     * Merges vertices with bit-equal positions, so that a seam of attributes is no crack of the surface.
     *
     * @param wanted true to merge them; an assembler that is told nothing keeps them apart
     * @return this
     */
    public MeshAssembler weld(boolean wanted) {
        weld = wanted;
        return this;
    }

    /** {@return the mesh of all that was given} */
    public Mesh build() {
        PositionWeld welded = null;
        if (weld) welded = positions == null ? PositionWeld.of(exactPositions) : PositionWeld.of(positions);
        MeshBuilder builder =
                new MeshBuilder().materials(materials).textures(textures).faceChannels(faceChannels);
        if (positions != null) builder.positions(weld ? welded.positions() : positions);
        else builder.positions(weld ? welded.exactPositions() : exactPositions);
        if (faceMaterials != null) builder.faceMaterials(faceMaterials);
        List<CornerAttribute> used = attributes.stream().filter(this::isUsed).toList();
        if (used.isEmpty()) {
            int[] faces = new int[faceCorners.length];
            for (int i = 0; i < faces.length; i++) faces[i] = vertex(welded, faceCorners[i]);
            return builder.faceWedges(faces).build();
        }
        int width = 1 + used.size();
        TupleIndex wedges = new TupleIndex(width);
        int[] faces = internWedges(welded, used, wedges);
        int[] order = byVertex(wedges);
        int[] rank = new int[order.length];
        for (int i = 0; i < order.length; i++) rank[order[i]] = i;
        for (int i = 0; i < faces.length; i++) faces[i] = rank[faces[i]];
        int[] wedgeVertices = new int[order.length];
        for (int i = 0; i < order.length; i++) wedgeVertices[i] = wedges.value(order[i], 0);
        List<Channel> channels = new ArrayList<>();
        for (int i = 0; i < used.size(); i++) channels.add(channel(used.get(i), wedges, order, i + 1));
        return builder.faceWedges(faces)
                .wedgeVertices(wedgeVertices)
                .channels(channels)
                .build();
    }

    private boolean isUsed(CornerAttribute attribute) {
        if (attribute.cornerRows() == null) return true;
        for (int corner : faceCorners) {
            if (attribute.cornerRows()[corner] >= 0) return true;
        }
        return false;
    }

    private int vertex(PositionWeld welded, int corner) {
        return welded == null ? cornerVertices[corner] : welded.vertex(cornerVertices[corner]);
    }

    private int[] internWedges(PositionWeld welded, List<CornerAttribute> used, TupleIndex wedges) {
        int[][] sameRows = new int[used.size()][];
        for (int i = 0; i < sameRows.length; i++) sameRows[i] = firstEqualRow(used.get(i));
        int[] key = new int[1 + used.size()];
        int[] faces = new int[faceCorners.length];
        for (int i = 0; i < faces.length; i++) {
            int corner = faceCorners[i];
            key[0] = vertex(welded, corner);
            for (int a = 0; a < sameRows.length; a++) {
                int[] rows = used.get(a).cornerRows();
                int row = rows == null ? cornerVertices[corner] : rows[corner];
                key[a + 1] = row < 0 ? -1 : sameRows[a][row];
            }
            faces[i] = wedges.intern(key, 0);
        }
        return faces;
    }

    private static int[] firstEqualRow(CornerAttribute attribute) {
        int words = attribute.words();
        int[] rows = attribute.rows();
        TupleIndex index = new TupleIndex(words);
        int[] first = new int[rows.length / words];
        int[] firstOfTuple = new int[first.length];
        for (int row = 0; row < first.length; row++) {
            int before = index.size();
            int id = index.intern(rows, row * words);
            if (id == before) firstOfTuple[id] = row;
            first[row] = firstOfTuple[id];
        }
        return first;
    }

    /** Wedge ids sorted by their vertex, stable. */
    private static int[] byVertex(TupleIndex wedges) {
        int vertices = 0;
        for (int w = 0; w < wedges.size(); w++) vertices = Math.max(vertices, wedges.value(w, 0) + 1);
        int[] start = new int[vertices + 1];
        for (int w = 0; w < wedges.size(); w++) start[wedges.value(w, 0) + 1]++;
        for (int v = 0; v < vertices; v++) start[v + 1] += start[v];
        int[] order = new int[wedges.size()];
        for (int w = 0; w < order.length; w++) order[start[wedges.value(w, 0)]++] = w;
        return order;
    }

    private static Channel channel(CornerAttribute attribute, TupleIndex wedges, int[] order, int key) {
        int words = attribute.words();
        int[] values = new int[Sizes.of(words, order.length, "corners with " + attribute.name())];
        BitSet absent = new BitSet();
        for (int i = 0; i < order.length; i++) {
            int row = wedges.value(order[i], key);
            if (row < 0) {
                absent.set(i);
            } else {
                System.arraycopy(attribute.rows(), row * words, values, i * words, words);
            }
        }
        return new Channel(
                attribute.semantic(), attribute.name(), attribute.components(), attribute.type(), values, absent);
    }

    /**
     * Takes the bits of numbers.
     *
     * @param values any numbers
     * @return the raw float bits of each
     */
    public static int[] bits(float[] values) {
        int[] bits = new int[values.length];
        Arrays.setAll(bits, i -> Float.floatToRawIntBits(values[i]));
        return bits;
    }
}
