package org.jsmesh.mesh;

import java.util.List;

/**
 * A triangle mesh M = {V, F, D, S} (section 3 of Chen and Nishita 2002): vertices with positions, faces, a material per
 * face, and wedges that carry the attribute channels.
 *
 * <p>Positions are float32 in most meshes. In a mesh in double precision ({@link #isDouble}) they are float32 offsets
 * from an {@link #origin}, to compute and to draw with, and {@link #exactPositions} has the coordinates themselves.
 *
 * <p>A face is three wedge ids; a wedge belongs to one vertex. Without channels there is one wedge per vertex. Arrays
 * are shared, not copied: treat a mesh as immutable. Built by {@link MeshBuilder}, which checks it.
 */
public final class Mesh {
    private final float[] positions;
    private final double[] origin;
    private final double[] exactPositions;
    private final int[] wedgeVertices;
    private final int[] faceWedges;
    private final int[] faceMaterials;
    private final List<Channel> channels;
    private final List<Material> materials;
    private final List<Texture> textures;
    private final List<Picture> previews;
    private final List<FaceChannel> faceChannels;

    Mesh(MeshBuilder b) {
        positions = b.positions;
        origin = b.origin;
        exactPositions = b.exactPositions;
        wedgeVertices = b.wedgeVertices;
        faceWedges = b.faceWedges;
        faceMaterials = b.faceMaterials;
        channels = List.copyOf(b.channels);
        materials = List.copyOf(b.materials);
        textures = List.copyOf(b.textures);
        previews = List.copyOf(b.previews);
        faceChannels = List.copyOf(b.faceChannels);
    }

    /** {@return the number of vertices} */
    public int vertices() {
        return positions.length / 3;
    }

    /** {@return the number of wedges, which is that of vertices when there are no channels} */
    public int wedges() {
        return wedgeVertices.length;
    }

    /** {@return the number of triangles} */
    public int faces() {
        return faceWedges.length / 3;
    }

    /** {@return x, y, z of each vertex, as offsets from the {@link #origin}; shared, not copied} */
    public float[] positions() {
        return positions;
    }

    /** {@return what positions count from: zeros but in double precision; shared, not copied} */
    public double[] origin() {
        return origin;
    }

    /**
     * The coordinates in double precision.
     *
     * @return x, y, z of each vertex, shared, not copied; null where float32 positions are exact, and in a mesh that is
     *     being decoded and whose last bits have not come
     */
    public double[] exactPositions() {
        return exactPositions;
    }

    /** {@return true when positions are offsets, or not all of what there is to know} */
    public boolean isDouble() {
        return exactPositions != null || origin[0] != 0 || origin[1] != 0 || origin[2] != 0;
    }

    /**
     * A coordinate of a vertex, as exactly as the mesh has it.
     *
     * @param vertex id of the vertex
     * @param axis 0, 1, 2 for x, y, z
     * @return the coordinate, with the origin in it
     */
    public double coordinate(int vertex, int axis) {
        int at = 3 * vertex + axis;
        if (exactPositions != null) return exactPositions[at];
        return origin[axis] == 0 ? positions[at] : origin[axis] + positions[at];
    }

    /** {@return the vertex of each wedge; shared, not copied} */
    public int[] wedgeVertices() {
        return wedgeVertices;
    }

    /** {@return three wedge ids per face, counter-clockwise; shared, not copied} */
    public int[] faceWedges() {
        return faceWedges;
    }

    /** {@return the material id of each face, −1 for none; shared, not copied} */
    public int[] faceMaterials() {
        return faceMaterials;
    }

    /** {@return the attributes of the wedges; the list cannot be changed} */
    public List<Channel> channels() {
        return channels;
    }

    /** {@return the materials, which face materials number from 0; the list cannot be changed} */
    public List<Material> materials() {
        return materials;
    }

    /** {@return images that came with the model; materials may name more} */
    public List<Texture> textures() {
        return textures;
    }

    /**
     * Small pictures to show in place of textures that have not arrived. Only a mesh that is being decoded has them;
     * they are no part of any original.
     *
     * @return the pictures, none for an original; the list cannot be changed
     */
    public List<Picture> previews() {
        return previews;
    }

    /** {@return attributes of the faces; the list cannot be changed} */
    public List<FaceChannel> faceChannels() {
        return faceChannels;
    }

    /**
     * Finds an attribute of the faces.
     *
     * @param name of the channel
     * @return the channel, or null
     */
    public FaceChannel faceChannel(String name) {
        for (FaceChannel c : faceChannels) if (c.name().equals(name)) return c;
        return null;
    }

    /**
     * Finds the vertex at a corner of a face.
     *
     * @param face id of the face
     * @param corner 0, 1 or 2
     * @return id of the vertex
     */
    public int vertex(int face, int corner) {
        return wedgeVertices[faceWedges[3 * face + corner]];
    }

    /**
     * Finds a channel by its meaning.
     *
     * @param semantic what the channel means to a viewer
     * @return the first channel with this meaning, or null
     */
    public Channel channel(Channel.Semantic semantic) {
        for (Channel c : channels) {
            if (c.semantic() == semantic) return c;
        }
        return null;
    }

    /** {@return smallest x, y, z, then largest x, y, z of all {@link #positions}; zeros when there is none} */
    public float[] bounds() {
        float[] b = new float[6];
        for (int i = 0; i < positions.length; i++) {
            int axis = i % 3;
            if (i < 3 || positions[i] < b[axis]) b[axis] = positions[i];
            if (i < 3 || positions[i] > b[axis + 3]) b[axis + 3] = positions[i];
        }
        return b;
    }
}
