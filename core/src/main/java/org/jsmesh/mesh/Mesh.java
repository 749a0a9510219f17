package org.jsmesh.mesh;

import java.util.List;

/**
 * A triangle mesh M = {V, F, D, S} (section 3 of Chen and Nishita 2002): vertices with float32 positions, faces, a
 * material per face, and wedges that carry the attribute channels.
 *
 * <p>A face is three wedge ids; a wedge belongs to one vertex. Without channels there is one wedge per vertex. Arrays
 * are shared, not copied: treat a mesh as immutable. Built by {@link MeshBuilder}, which checks it.
 */
public final class Mesh {
    private final float[] positions;
    private final int[] wedgeVertices;
    private final int[] faceWedges;
    private final int[] faceMaterials;
    private final List<Channel> channels;
    private final List<Material> materials;
    private final List<Texture> textures;
    private final List<Picture> previews;

    Mesh(MeshBuilder b) {
        positions = b.positions;
        wedgeVertices = b.wedgeVertices;
        faceWedges = b.faceWedges;
        faceMaterials = b.faceMaterials;
        channels = List.copyOf(b.channels);
        materials = List.copyOf(b.materials);
        textures = List.copyOf(b.textures);
        previews = List.copyOf(b.previews);
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

    /** {@return x, y, z of each vertex; shared, not copied} */
    public float[] positions() {
        return positions;
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

    /** {@return smallest x, y, z, then largest x, y, z of all vertices; zeros when there is none} */
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
