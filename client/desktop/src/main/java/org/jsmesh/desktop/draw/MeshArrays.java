package org.jsmesh.desktop.draw;

import java.util.Arrays;
import org.jsmesh.display.LiveMesh;
import org.jsmesh.display.LiveStep;
import org.jsmesh.display.RenderMesh;
import org.jsmesh.mesh.Sizes;

/** The arrays of a mesh to draw as raw bits, numbered as those of {@link LiveStep}. They grow. */
final class MeshArrays {
    /** Number of an array that is made here: distances of vertices, for {@link Shading#ERROR}. */
    static final int DISTANCES = LiveMesh.STARTS + 1;

    static final int COUNT = DISTANCES + 1;

    private final int[][] arrays = new int[COUNT][];
    private final int[] used = new int[COUNT];
    private final int[] expected = new int[COUNT];

    /** Arrays of a whole mesh. */
    static MeshArrays of(RenderMesh mesh) {
        MeshArrays all = new MeshArrays();
        all.set(LiveStep.POSITIONS, bits(mesh.positions()));
        all.set(LiveStep.NORMALS, bits(mesh.normals()));
        all.set(LiveStep.COLOURS, mesh.colours());
        all.set(LiveStep.INDICES, mesh.indices());
        all.set(LiveStep.TANGENTS, bits(mesh.tangents()));
        for (int i = 0; i < RenderMesh.SETS; i++) all.set(LiveStep.FIRST_SET + i, bits(mesh.textureCoordinates()[i]));
        return all;
    }

    /** Of an error map: triangles that share no corners. */
    static MeshArrays of(ErrorMap map) {
        MeshArrays all = new MeshArrays();
        all.set(LiveStep.POSITIONS, bits(map.positions()));
        all.set(DISTANCES, bits(map.distances()));
        int[] indices = new int[map.distances().length];
        for (int i = 0; i < indices.length; i++) indices[i] = i;
        all.set(LiveStep.INDICES, indices);
        return all;
    }

    /** Numbers of a vertex, or of a triangle, in an array. */
    static int width(int array) {
        return array == DISTANCES ? 1 : LiveStep.width(array);
    }

    private void set(int array, int[] values) {
        if (values.length == 0) return;
        arrays[array] = values;
        used[array] = values.length;
    }

    private static int[] bits(float[] numbers) {
        int[] bits = new int[numbers.length];
        for (int i = 0; i < bits.length; i++) bits[i] = Float.floatToRawIntBits(numbers[i]);
        return bits;
    }

    /** Makes room for so many elements, where the array is none yet or smaller. */
    void reserve(int array, int elements) {
        if (arrays[array] == null) arrays[array] = new int[elements];
        else if (arrays[array].length < elements) arrays[array] = Arrays.copyOf(arrays[array], elements);
    }

    /** So many elements of an array are expected in the end. There is room for them when most of them have come. */
    void expect(int array, int elements) {
        expected[array] = elements;
    }

    /** Writes elements; an array grows where it has no room. */
    void write(int array, int first, int[] data, int at, int count) {
        int end = first + count;
        if (arrays[array] == null || arrays[array].length < end) reserve(array, grown(array, end));
        System.arraycopy(data, at, arrays[array], first, count);
        used[array] = Math.max(used[array], first + count);
    }

    /** By half beyond what was expected; else to twice as much, or to all where that is hardly more. */
    private int grown(int array, int needed) {
        if (needed > expected[array]) return (int) Math.min(Sizes.MOST, needed + needed / 2L);
        int had = arrays[array] == null ? 0 : arrays[array].length;
        long size = Math.max(needed, 2L * had);
        return size > expected[array] / 2 ? expected[array] : (int) size;
    }

    boolean has(int array) {
        return used[array] > 0;
    }

    /** Raw bits; null where the mesh lacks the array. There may be more than are used. */
    int[] bits(int array) {
        return arrays[array];
    }

    /** Elements in use. */
    int used(int array) {
        return used[array];
    }

    int vertices() {
        return used[LiveStep.POSITIONS] / 3;
    }

    /** Three coordinates per vertex. */
    float[] positions() {
        float[] positions = new float[used[LiveStep.POSITIONS]];
        for (int i = 0; i < positions.length; i++) positions[i] = Float.intBitsToFloat(arrays[LiveStep.POSITIONS][i]);
        return positions;
    }

    /** The indices of some groups, one after the other. */
    int[] indices(int[] groups) {
        int count = 0;
        for (int g = 0; g < groups.length; g += 3) count += groups[g + 2];
        int[] all = new int[count];
        int at = 0;
        for (int g = 0; g < groups.length; g += 3) {
            System.arraycopy(arrays[LiveStep.INDICES], groups[g + 1], all, at, groups[g + 2]);
            at += groups[g + 2];
        }
        return all;
    }
}
