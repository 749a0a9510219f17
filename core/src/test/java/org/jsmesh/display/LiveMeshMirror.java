package org.jsmesh.display;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** What a graphics card has that gets nothing but the changed ranges of a {@link LiveMesh}. */
final class LiveMeshMirror {
    private static final int PORTION = 40;
    private static final int ANYTHING = 0x7fc0ffee;
    private static final int[] WIDTHS = {3, 3, 1, 0, 0, 4, 2, 2, 2, 2};

    private final int[][] arrays = new int[LiveMesh.ARRAYS][0];
    private int[] groups = {};
    private int step;

    /** Elements that came with the last step. */
    long elements;

    int ranges;

    void take(LiveMesh mesh) {
        ByteBuffer buffer = ByteBuffer.allocateDirect(PORTION).order(ByteOrder.LITTLE_ENDIAN);
        elements = 0;
        ranges = mesh.ranges();
        buffer.limit(0);
        for (int r = 0; r < mesh.ranges(); r++) {
            int array = mesh.array(r);
            int end = mesh.first(r) + mesh.count(r);
            if (end > arrays[array].length) arrays[array] = Arrays.copyOf(arrays[array], end);
            for (int i = mesh.first(r); i < end; i++) {
                if (!buffer.hasRemaining()) {
                    buffer.clear();
                    mesh.copy((int) elements, buffer);
                    buffer.flip();
                }
                arrays[array][i] = buffer.getInt();
                elements++;
            }
        }
        buffer.clear();
        if (mesh.copy((int) elements, buffer) != 0) throw new AssertionError("more than its ranges");
        groups = mesh.groups();
        step = mesh.step();
    }

    /** The same from a copy of a step, into buffers that begin with anything. */
    void take(LiveStep step) {
        int at = 0;
        for (int r = 0; r < step.ranges().length; r += 3) {
            int array = step.ranges()[r];
            int first = step.ranges()[r + 1];
            int count = step.ranges()[r + 2];
            int before = arrays[array].length;
            if (first + count > before) {
                arrays[array] = Arrays.copyOf(arrays[array], first + count);
                Arrays.fill(arrays[array], before, first + count, ANYTHING);
            }
            System.arraycopy(step.data(), at, arrays[array], first, count);
            at += count;
        }
        if (at != step.data().length) throw new AssertionError("more than its ranges");
        groups = step.groups();
    }

    /** The bits of all triangles with the data of their corners, sorted. */
    int[][] triangles() {
        List<int[]> list = new ArrayList<>();
        for (int g = 0; g < groups.length; g += 3)
            for (int i = groups[g + 1]; i < groups[g + 1] + groups[g + 2]; i += 3)
                list.add(triangle(arrays, groups[g], i));
        return sorted(list);
    }

    static int[][] triangles(RenderMesh mesh) {
        int[][] arrays = new int[RenderMesh.ARRAYS][];
        for (int a = 0; a < arrays.length; a++) {
            arrays[a] = new int[mesh.count(a)];
            for (int i = 0; i < arrays[a].length; i++) arrays[a][i] = mesh.bits(a, i);
        }
        List<int[]> list = new ArrayList<>();
        for (int g = 0; g < mesh.groups().length; g += 3)
            for (int i = mesh.groups()[g + 1]; i < mesh.groups()[g + 1] + mesh.groups()[g + 2]; i += 3)
                list.add(triangle(arrays, mesh.groups()[g], i));
        return sorted(list);
    }

    private static int[] triangle(int[][] arrays, int slot, int first) {
        int[] all = new int[1 + 3 * 19];
        int n = 0;
        all[n++] = slot;
        for (int i = first; i < first + 3; i++) {
            int vertex = arrays[3][i];
            for (int a = 0; a < WIDTHS.length; a++)
                for (int k = 0; k < WIDTHS[a]; k++) {
                    int at = WIDTHS[a] * vertex + k;
                    all[n++] = at < arrays[a].length ? arrays[a][at] : 0; // buffers begin with zeros
                }
        }
        return all;
    }

    /** The corners of all triangles that have three, where they start from; sorted. */
    int[][] starts() {
        return places(true);
    }

    /** The corners of all triangles that have three; sorted. */
    int[][] ends() {
        return places(false);
    }

    private int[][] places(boolean atStart) {
        List<int[]> list = new ArrayList<>();
        for (int g = 0; g < groups.length; g += 3)
            for (int i = groups[g + 1]; i < groups[g + 1] + groups[g + 2]; i += 3) {
                int[] xyz = new int[9];
                for (int j = 0; j < 3; j++) {
                    int v = arrays[3][i + j];
                    int[] starts = arrays[LiveMesh.STARTS];
                    boolean glides = 4 * v + 3 < starts.length && Float.intBitsToFloat(starts[4 * v + 3]) == step;
                    if (glides && atStart) System.arraycopy(starts, 4 * v, xyz, 3 * j, 3);
                    else System.arraycopy(arrays[0], 3 * v, xyz, 3 * j, 3);
                }
                if (!isFlat(xyz)) list.add(turned(xyz));
            }
        return sorted(list);
    }

    private static boolean isFlat(int[] xyz) {
        return Arrays.equals(xyz, 0, 3, xyz, 3, 6)
                || Arrays.equals(xyz, 3, 6, xyz, 6, 9)
                || Arrays.equals(xyz, 0, 3, xyz, 6, 9);
    }

    /** Begins with the smallest corner. */
    private static int[] turned(int[] xyz) {
        int[] best = xyz;
        for (int turn = 3; turn < 9; turn += 3) {
            int[] other = new int[9];
            for (int i = 0; i < 9; i++) other[i] = xyz[(i + turn) % 9];
            if (Arrays.compare(other, best) < 0) best = other;
        }
        return best;
    }

    private static int[][] sorted(List<int[]> list) {
        list.sort(Arrays::compare);
        return list.toArray(new int[0][]);
    }
}
