package org.jsmesh.mesh;

import java.util.Arrays;
import java.util.List;

/**
 * Collects the parts of a {@link Mesh} and checks them. Parts not given are empty: no wedges means one per vertex, no
 * face materials means none. Arrays are taken over, not copied.
 *
 * <p>Not thread-safe. A builder is used for one mesh.
 */
public final class MeshBuilder {
    float[] positions = new float[0];
    double[] origin = new double[3];
    double[] exactPositions;
    int[] wedgeVertices;
    int[] faceWedges = new int[0];
    int[] faceMaterials;
    List<Channel> channels = List.of();
    List<Material> materials = List.of();
    List<Texture> textures = List.of();
    List<Picture> previews = List.of();
    List<FaceChannel> faceChannels = List.of();

    /**
     * Sets the vertices.
     *
     * @param xyz x, y, z of each vertex
     * @return this
     */
    public MeshBuilder positions(float[] xyz) {
        positions = xyz;
        origin = new double[3];
        exactPositions = null;
        return this;
    }

    /**
     * Sets the vertices in double precision. Where float32 holds all coordinates, the mesh is one of float32.
     *
     * @param xyz x, y, z of each vertex
     * @return this
     */
    public MeshBuilder positions(double[] xyz) {
        float[] floats = DoublePositions.asFloats(xyz);
        if (floats != null) return positions(floats);
        DoublePositions split = new DoublePositions(xyz);
        return offsets(split.origin, split.offsets, split.exact);
    }

    /**
     * Sets the vertices as offsets from an origin.
     *
     * @param from what the offsets count from
     * @param offsets x, y, z of each vertex, to compute and to draw with
     * @param exact the coordinates in double precision, or null where they are not known
     * @return this
     */
    public MeshBuilder offsets(double[] from, float[] offsets, double[] exact) {
        origin = from;
        positions = offsets;
        exactPositions = exact;
        return this;
    }

    /**
     * Sets the wedges.
     *
     * @param vertices the vertex of each wedge
     * @return this
     */
    public MeshBuilder wedgeVertices(int[] vertices) {
        wedgeVertices = vertices;
        return this;
    }

    /**
     * Sets the faces.
     *
     * @param wedges three wedge ids per face, counter-clockwise
     * @return this
     */
    public MeshBuilder faceWedges(int[] wedges) {
        faceWedges = wedges;
        return this;
    }

    /**
     * Sets the materials of the faces.
     *
     * @param ids the material id of each face, −1 for none
     * @return this
     */
    public MeshBuilder faceMaterials(int[] ids) {
        faceMaterials = ids;
        return this;
    }

    /**
     * Sets the attributes.
     *
     * @param list one channel for each attribute, with values for every wedge
     * @return this
     */
    public MeshBuilder channels(List<Channel> list) {
        channels = list;
        return this;
    }

    /**
     * Sets the materials.
     *
     * @param list the materials that faces name by their place
     * @return this
     */
    public MeshBuilder materials(List<Material> list) {
        materials = list;
        return this;
    }

    /**
     * Sets the images.
     *
     * @param list the images that come with the model
     * @return this
     */
    public MeshBuilder textures(List<Texture> list) {
        textures = list;
        return this;
    }

    /**
     * Sets the pictures that stand for images.
     *
     * @param list the pictures to show until the images arrive
     * @return this
     */
    public MeshBuilder previews(List<Picture> list) {
        previews = list;
        return this;
    }

    /**
     * Sets the attributes of the faces.
     *
     * @param list one channel for each attribute, with values for every face
     * @return this
     */
    public MeshBuilder faceChannels(List<FaceChannel> list) {
        faceChannels = list;
        return this;
    }

    /**
     * Takes over all parts of another mesh, to change some of them.
     *
     * @param mesh whose arrays are shared, not copied
     * @return a builder that would build the same mesh
     */
    public static MeshBuilder from(Mesh mesh) {
        return new MeshBuilder()
                .offsets(mesh.origin(), mesh.positions(), mesh.exactPositions())
                .wedgeVertices(mesh.wedgeVertices())
                .faceWedges(mesh.faceWedges())
                .faceMaterials(mesh.faceMaterials())
                .channels(mesh.channels())
                .materials(mesh.materials())
                .textures(mesh.textures())
                .previews(mesh.previews())
                .faceChannels(mesh.faceChannels());
    }

    /**
     * Checks the parts and makes the mesh.
     *
     * @return the mesh, which shares the arrays
     * @throws IllegalArgumentException when an id is out of range or array lengths disagree
     */
    public Mesh build() {
        if (positions.length % 3 != 0) throw new IllegalArgumentException("positions: " + positions.length + " values");
        if (faceWedges.length % 3 != 0)
            throw new IllegalArgumentException("faceWedges: " + faceWedges.length + " values");
        int vertices = positions.length / 3;
        int faces = faceWedges.length / 3;
        if (wedgeVertices == null) {
            wedgeVertices = new int[vertices];
            for (int i = 0; i < vertices; i++) wedgeVertices[i] = i;
        }
        if (faceMaterials == null) {
            faceMaterials = new int[faces];
            Arrays.fill(faceMaterials, -1);
        }
        if (faceMaterials.length != faces)
            throw new IllegalArgumentException(faceMaterials.length + " face materials for " + faces + " faces");
        checkIds("vertex of wedge", wedgeVertices, 0, vertices);
        checkIds("wedge of corner", faceWedges, 0, wedgeVertices.length);
        checkIds("material of face", faceMaterials, -1, materials.size());
        for (Channel c : channels) {
            if (c.wedges() != wedgeVertices.length) {
                throw new IllegalArgumentException(
                        "channel " + c.name() + " has " + c.wedges() + " wedges of " + wedgeVertices.length);
            }
        }
        for (FaceChannel c : faceChannels) {
            if (c.faces() != faces)
                throw new IllegalArgumentException("channel " + c.name() + " has " + c.faces() + " faces of " + faces);
        }
        if (exactPositions != null && exactPositions.length != positions.length)
            throw new IllegalArgumentException(exactPositions.length + " coordinates of " + positions.length);
        return new Mesh(this);
    }

    private static void checkIds(String what, int[] ids, int from, int to) {
        for (int i = 0; i < ids.length; i++) {
            if (ids[i] < from || ids[i] >= to)
                throw new IllegalArgumentException(
                        what + " " + i + " is " + ids[i] + ", not in [" + from + ", " + to + ")");
        }
    }
}
