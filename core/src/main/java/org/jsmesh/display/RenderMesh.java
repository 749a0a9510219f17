package org.jsmesh.display;

import java.nio.ByteBuffer;
import org.jsmesh.mesh.Mesh;

/**
 * A mesh as vertex and index arrays for a graphics card: the one form in which every viewer draws.
 *
 * <p>A render vertex is a wedge. Where a model without normals has a crease, a wedge has one render vertex for each
 * side of it. The first render vertex of wedge {@code w} has the number {@code w}, so numbers stay as a mesh is
 * refined; those that creases add follow after the wedges. Faces are sorted by {@link DisplaySlots slot}; within a slot
 * they keep their order.
 *
 * <p>Arrays are shared, not copied. An array that the mesh lacks is empty. Instances may be read by many threads.
 *
 * @param positions x, y, z per render vertex, in the units of the model
 * @param normals x, y, z per render vertex: those of the file where it has them, else unit vectors computed from the
 *     faces; (0, 0, 1) where the faces around a vertex have no area
 * @param textureCoordinates u, v per render vertex
 * @param colours one per render vertex: red, green, blue, alpha from the lowest byte on, sRGB. White where the wedge
 *     has none
 * @param indices render vertices of the faces, three per face, counter-clockwise
 * @param groups three numbers per slot, in the order of the slots: the slot, its first element of {@code indices}, its
 *     number of elements of {@code indices}
 * @param slots the display materials of the groups
 */
public record RenderMesh(
        float[] positions,
        float[] normals,
        float[] textureCoordinates,
        int[] colours,
        int[] indices,
        int[] groups,
        DisplaySlots slots) {
    private static final int COLOURS = 3;

    /**
     * Makes the arrays of a mesh.
     *
     * @param mesh with any materials and attributes; it must not be changed afterwards, as arrays may be its own
     * @param creaseCosine cosine of the angle between faces above which an edge is a crease, see {@link CreaseAngle}.
     *     It counts for wedges that have no normal of their own
     * @return the arrays to draw
     */
    public static RenderMesh of(Mesh mesh, double creaseCosine) {
        return new RenderMeshBuilder(mesh, creaseCosine).build();
    }

    /**
     * The same mesh at other places, for instance in the units of a viewer.
     *
     * @param others x, y, z per render vertex, as many numbers as in {@link #positions}
     * @return a mesh that shares all other arrays with this one
     */
    public RenderMesh withPositions(float[] others) {
        return new RenderMesh(others, normals, textureCoordinates, colours, indices, groups, slots);
    }

    /** {@return the number of render vertices, which is that of wedges or, with creases, a larger one} */
    public int vertices() {
        return positions.length / 3;
    }

    /** {@return the number of triangles, that of the mesh} */
    public int faces() {
        return indices.length / 3;
    }

    /**
     * Where each face of the mesh lies in {@link #indices}.
     *
     * @param mesh the one that this was made of
     * @return per face the first of its three elements of {@code indices}
     */
    public int[] firstIndices(Mesh mesh) {
        return slots.firstIndices(mesh.faceMaterials(), groups);
    }

    /**
     * Elements of an array.
     *
     * @param array 0 for positions, 1 for normals, 2 for texture coordinates, 3 for colours, 4 for indices, 5 for
     *     groups
     * @return numbers in the array, for positions three per render vertex; 0 when the mesh lacks the array
     * @throws IllegalArgumentException for any other array
     */
    public int count(int array) {
        return array < COLOURS ? floats(array).length : ints(array).length;
    }

    /**
     * Copies elements of an array into a buffer, as many as fit.
     *
     * @param array as for {@link #count}
     * @param from the first element
     * @param buffer takes four bytes per element in its own byte order; its position stays
     * @return elements copied
     */
    public int copy(int array, int from, ByteBuffer buffer) {
        int length = Math.min(buffer.remaining() / 4, count(array) - from);
        if (array < COLOURS) buffer.asFloatBuffer().put(floats(array), from, length);
        else buffer.asIntBuffer().put(ints(array), from, length);
        return length;
    }

    private float[] floats(int array) {
        return switch (array) {
            case 0 -> positions;
            case 1 -> normals;
            case 2 -> textureCoordinates;
            default -> throw new IllegalArgumentException("array " + array);
        };
    }

    private int[] ints(int array) {
        return switch (array) {
            case COLOURS -> colours;
            case 4 -> indices;
            case 5 -> groups;
            default -> throw new IllegalArgumentException("array " + array);
        };
    }
}
