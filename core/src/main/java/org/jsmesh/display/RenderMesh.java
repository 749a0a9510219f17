package org.jsmesh.display;

import java.util.List;
import org.jsmesh.mesh.Channel;
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
 * @param tangents x, y, z along u and the sign of the direction of v, per render vertex, where the file has them: the
 *     channel {@value #TANGENT}. Zeros where the wedge has none
 * @param textureCoordinates u, v per render vertex, for each set that materials may name; a set that is missing is
 *     empty
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
        float[] tangents,
        float[][] textureCoordinates,
        int[] colours,
        int[] indices,
        int[] groups,
        DisplaySlots slots) {
    private static final int FIRST_SET = 6; // array

    /** Name of the channel with tangents of four components, as glTF calls it. */
    static final String TANGENT = "TANGENT";

    /** Sets of texture coordinates that are drawn. */
    public static final int SETS = 4;

    /** Arrays that {@link #count} and {@link #bits} number from 0. */
    static final int ARRAYS = FIRST_SET + SETS;

    /** What glTF calls sets of texture coordinates, in front of their number. */
    private static final String GLTF_SET = "TEXCOORD_";

    /**
     * Makes the arrays of a mesh.
     *
     * @param mesh with any materials and attributes; it must not be changed afterwards, as arrays may be its own
     * @param creaseCosine cosine of the angle between faces above which an edge is a crease, see {@link CreaseAngle}.
     *     It counts for wedges that have no normal of their own, where the mesh has no smoothing groups
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
        return new RenderMesh(others, normals, tangents, textureCoordinates, colours, indices, groups, slots);
    }

    /**
     * Replaces the normals.
     *
     * @param others x, y, z per render vertex, as many numbers as in {@link #normals}
     * @return a mesh that shares all other arrays with this one
     */
    public RenderMesh withNormals(float[] others) {
        return new RenderMesh(positions, others, tangents, textureCoordinates, colours, indices, groups, slots);
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
     * The same mesh with other tangents.
     *
     * @param others x, y, z, sign per render vertex, as many numbers as in {@link #tangents}
     * @return a mesh that shares all other arrays with this one
     */
    public RenderMesh withTangents(float[] others) {
        return new RenderMesh(positions, normals, others, textureCoordinates, colours, indices, groups, slots);
    }

    /**
     * The texture coordinates of a mesh by the numbers that materials name: those that glTF gives them, else their
     * order.
     *
     * @param mesh with any channels
     * @return {@value #SETS} channels of at least two components, null where there is none
     */
    public static Channel[] textureSets(Mesh mesh) {
        return textureSets(mesh.channels());
    }

    static Channel[] textureSets(List<Channel> channels) {
        Channel[] sets = new Channel[SETS];
        int ordinal = 0;
        for (Channel uv : channels) {
            if (uv.semantic() != Channel.Semantic.TEXCOORD) continue;
            int set = set(uv.name(), ordinal++);
            if (set < SETS && uv.components() > 1) sets[set] = uv;
        }
        return sets;
    }

    private static int set(String name, int ordinal) {
        boolean named = name.length() == GLTF_SET.length() + 1 && name.startsWith(GLTF_SET);
        int digit = named ? name.charAt(GLTF_SET.length()) - '0' : -1;
        return digit >= 0 && digit <= 9 ? digit : ordinal;
    }

    /** {@return whether there are texture coordinates of any set} */
    public boolean hasTextureCoordinates() {
        for (float[] set : textureCoordinates) if (set.length > 0) return true;
        return false;
    }

    /**
     * Elements of an array.
     *
     * @param array 0 for positions, 1 for normals, 2 for colours, 3 for indices, 4 for groups, 5 for tangents, 6 to 9
     *     for the sets of texture coordinates
     * @return numbers in the array, for positions three per render vertex; 0 when the mesh lacks the array
     * @throws IllegalArgumentException for any other array
     */
    int count(int array) {
        int[] ints = ints(array);
        return ints == null ? floats(array).length : ints.length;
    }

    /** An element of an array as raw bits. */
    int bits(int array, int element) {
        int[] ints = ints(array);
        return ints == null ? Float.floatToIntBits(floats(array)[element]) : ints[element];
    }

    private float[] floats(int array) {
        return switch (array) {
            case 0 -> positions;
            case 1 -> normals;
            case 5 -> tangents;
            default -> {
                if (array < FIRST_SET || array >= ARRAYS) throw new IllegalArgumentException("array " + array);
                yield textureCoordinates[array - FIRST_SET];
            }
        };
    }

    private int[] ints(int array) {
        return switch (array) {
            case 2 -> colours;
            case 3 -> indices;
            case 4 -> groups;
            default -> null;
        };
    }
}
