package org.jsmesh.display;

import java.util.ArrayList;
import java.util.List;

/**
 * A copy of what one step of a {@link LiveMesh} changes, for another thread. Rows that are new come whole, also where
 * they are zero, so that buffers need not begin with zeros. Arrays are shared, not copied.
 *
 * @param number of the step; 1 is the first one of a mesh
 * @param isJump whether the arrays are others as a whole, so that nothing of a picture stays while they are replaced
 * @param vertices render vertices that there is room for, used or not
 * @param places triangles that there is room for, used or not
 * @param faces triangles shown
 * @param ranges three numbers per range, in the order in which they are to be applied: its array as
 *     {@link LiveMesh#array} numbers them, its first element, its elements. Ranges begin and end with rows, see
 *     {@link #width}
 * @param data elements of all ranges, one after the other, as raw bits
 * @param groups as {@link LiveMesh#groups} gives them
 * @param slots the display materials of the groups
 */
public record LiveStep(
        int number,
        boolean isJump,
        int vertices,
        int places,
        int faces,
        int[] ranges,
        int[] data,
        int[] groups,
        DisplaySlots slots) {
    /** Array of x, y, z per render vertex. */
    public static final int POSITIONS = LiveMesh.POSITIONS;

    /** Array of x, y, z per render vertex. */
    public static final int NORMALS = LiveMesh.NORMALS;

    /** Array of colours, one number per render vertex. */
    public static final int COLOURS = LiveMesh.COLOURS;

    /** Array of render vertices, three per triangle. */
    public static final int INDICES = LiveMesh.INDICES;

    /** Array of x, y, z, sign per render vertex. */
    public static final int TANGENTS = LiveMesh.TANGENTS;

    /** The first of {@link RenderMesh#SETS} arrays of u, v per render vertex. */
    public static final int FIRST_SET = LiveMesh.FIRST_SET;

    private static final int[] WIDTHS = {3, 3, 1, 3, 0, 4, 2, 2, 2, 2, 4};

    /**
     * Copies the last step.
     *
     * @param mesh that was updated just now
     * @param known render vertices of the step before, 0 for none
     * @param isJump whether it was replaced
     * @return the step, which stays as it is
     */
    public static LiveStep of(LiveMesh mesh, int known, boolean isJump) {
        List<int[]> ranges = new ArrayList<>();
        for (int a = 0; a < LiveMesh.ARRAYS; a++)
            if (a != INDICES && mesh.row(a) != null) addGaps(mesh, a, known, ranges);
        for (int r = 0; r < mesh.ranges(); r++) ranges.add(new int[] {mesh.array(r), mesh.first(r), mesh.count(r)});
        int[] rows = new int[3 * ranges.size()];
        int elements = 0;
        for (int r = 0; r < ranges.size(); r++) {
            System.arraycopy(ranges.get(r), 0, rows, 3 * r, 3);
            elements += rows[3 * r + 2];
        }
        int[] data = new int[elements];
        int at = 0;
        for (int r = 0; r < rows.length; r += 3) {
            mesh.row(rows[r]).copy(rows[r + 1], rows[r + 2], data, at);
            at += rows[r + 2];
        }
        return new LiveStep(
                mesh.step(),
                isJump,
                mesh.vertices(),
                mesh.places(),
                mesh.faces(),
                rows,
                data,
                mesh.groups(),
                mesh.slots());
    }

    /** New rows that no range has. Those of an array come in ascending order. */
    private static void addGaps(LiveMesh mesh, int array, int known, List<int[]> to) {
        int from = WIDTHS[array] * known;
        for (int r = 0; r < mesh.ranges(); r++) {
            if (mesh.array(r) != array) continue;
            if (mesh.first(r) > from) to.add(new int[] {array, from, mesh.first(r) - from});
            from = Math.max(from, mesh.first(r) + mesh.count(r));
        }
        int end = WIDTHS[array] * mesh.vertices();
        if (end > from) to.add(new int[] {array, from, end - from});
    }

    /**
     * Numbers in a row.
     *
     * @param array its number
     * @return those of one render vertex, or of one triangle
     */
    public static int width(int array) {
        return WIDTHS[array];
    }

    /** {@return the bytes of all ranges} */
    public long bytes() {
        return 4L * data.length;
    }
}
