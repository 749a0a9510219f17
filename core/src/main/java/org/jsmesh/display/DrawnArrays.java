package org.jsmesh.display;

import java.nio.ByteBuffer;

/**
 * The arrays of a mesh as a graphics card takes them, by number: {@value #POSITIONS} positions (3 floats per render
 * vertex), {@value #NORMALS} normals (3 floats), {@value #TEXTURE_COORDINATES} texture coordinates (2 floats),
 * {@value #COLOURS} colours (one int per render vertex: red, green, blue, alpha from the lowest byte on, sRGB),
 * {@value #INDICES} render vertices of the faces (3 ints per face), {@value #GROUPS} groups (3 ints each: display slot,
 * first index, indices). An array that the mesh lacks is empty.
 */
public record DrawnArrays(
        float[] positions, float[] normals, float[] textureCoordinates, int[] colours, int[] indices, int[] groups) {
    static final int POSITIONS = 0;
    static final int NORMALS = 1;
    static final int TEXTURE_COORDINATES = 2;
    static final int COLOURS = 3;
    static final int INDICES = 4;
    static final int GROUPS = 5;

    public int vertices() {
        return positions.length / 3;
    }

    public int count(int array) {
        return array < COLOURS ? floats(array).length : ints(array).length;
    }

    /** Puts elements from {@code from} on into a buffer of native order and says how many fitted. */
    public int copy(int array, int from, ByteBuffer buffer) {
        int length = Math.min(buffer.remaining() / 4, count(array) - from);
        if (array < COLOURS) buffer.asFloatBuffer().put(floats(array), from, length);
        else buffer.asIntBuffer().put(ints(array), from, length);
        return length;
    }

    private float[] floats(int array) {
        return switch (array) {
            case POSITIONS -> positions;
            case NORMALS -> normals;
            case TEXTURE_COORDINATES -> textureCoordinates;
            default -> throw new IllegalArgumentException("array " + array);
        };
    }

    private int[] ints(int array) {
        return switch (array) {
            case COLOURS -> colours;
            case INDICES -> indices;
            case GROUPS -> groups;
            default -> throw new IllegalArgumentException("array " + array);
        };
    }
}
