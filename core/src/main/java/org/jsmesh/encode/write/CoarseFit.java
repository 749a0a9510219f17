package org.jsmesh.encode.write;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.jsmesh.codec.MeshFormat;
import org.jsmesh.codec.connectivity.CodedMesh;
import org.jsmesh.encode.measure.SurfaceFit;
import org.jsmesh.encode.measure.UnitGrid;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.Mesh;

/**
 * Finds where the vertices of coarse levels are shown until they are brought back to their own positions. There are
 * stages. At the begin of a stage, all vertices move to where the surfaces of its levels are closest to the original.
 * The last levels of a stage are not fitted, and their new vertices have their own positions. The old vertices, still
 * moved, suit these levels less and less, so the picture gets no worse when all of them move at once.
 */
public final class CoarseFit {
    /**
     * Vertices are brought back before more than this share of all vertices is there. Later, moving would cost more
     * than it gains.
     */
    private static final double SHARE = 0.3;

    /**
     * The same in symmetric models, where places are not chosen: image and vertex would be rounded to different sides.
     */
    private static final double SHARE_OF_SYMMETRIC = 0.19;

    /** Vertices at the end of a stage, divided by those of the last level that is fitted. */
    private static final double HELD_GROWTH = 1.15;

    /** The same for the last stage, after which no vertex is fitted. */
    private static final double LAST_HELD_GROWTH = 1.35;

    private static final double GROWTH = 1.25; // of vertices, from one level that is fitted to the next

    /** Least growth of the vertices in the first stage. With less, it is joined with the second. */
    private static final double FEWEST_GROWTH = 1.5;

    /** A stage may end when its error is not below this share of the error in the next stage. */
    private static final double LEAST_SHARE = 0.91;

    /** Time and bytes that the picture of coarse levels may cost. */
    public enum Effort {
        NONE(0, 2.5),
        SOME(20_000, 2.5),
        MUCH(40_000, 2);

        /** Most vertices that are moved, because fitting takes time. */
        private final int mostVertices;

        /**
         * Vertices at the end of a stage, divided by those at the end of the one before. No place of a vertex is the
         * best for all levels.
         */
        private final double stageGrowth;

        Effort(int mostVertices, double stageGrowth) {
            this.mostVertices = mostVertices;
            this.stageGrowth = stageGrowth;
        }
    }

    private final SurfaceFit fitter;
    private final PrecisionSchedule precision;
    private final Effort effort;
    private final Deque<Stage> stages = new ArrayDeque<>();

    /** Moves in cells, the pass of the log before which the stage ends, and the shift of positions in it, or 0. */
    private record Stage(int[] moves, int lastPass, int shift) {}

    CoarseFit(SurfaceFit fitter, PrecisionSchedule precision, Effort effort) {
        this.precision = precision;
        this.fitter = fitter;
        this.effort = effort;
    }

    /** The pass of the log before which the present stage ends. Passes with greater numbers are undone earlier. */
    int lastPass() {
        return stages.getFirst().lastPass;
    }

    /** Cells by which to move the vertices of the original along x, y, z in the present stage. */
    int[] moves() {
        return stages.getFirst().moves;
    }

    /** The shift of all positions in the present stage, or the given one where the stage has none of its own. */
    int shift(int otherwise) {
        int shift = stages.getFirst().shift;
        return shift == 0 ? otherwise : shift;
    }

    /** Goes on to the next stage. Returns false when there is none, and vertices come back. */
    boolean next() {
        stages.removeFirst();
        return !stages.isEmpty();
    }

    /** Finds all moves. Returns false where none is worth it. */
    boolean find(CodedMesh source, MeshFormat format) {
        int[] vertices = vertices(source);
        int base = vertices.length - 1;
        double share = format.hasMirror() ? SHARE_OF_SYMMETRIC : SHARE;
        int end = last(
                vertices,
                Math.min(effort.mostVertices, share * source.original().vertices()));
        if (end > base) return false;
        CoarseLevels levels = new CoarseLevels(source, end);
        for (double held = LAST_HELD_GROWTH; end <= base; held = HELD_GROWTH) {
            levels.goTo(end);
            int[] shown = levels.triangles();
            int before = last(vertices, vertices[end] / effort.stageGrowth);
            boolean isFirst = before > base || vertices[before] < FEWEST_GROWTH * vertices[base];
            int start = isFirst ? base : before;
            List<int[]> fitted = new ArrayList<>(); // finest first
            for (int pass = last(vertices, vertices[end] / held); pass < start; ) {
                levels.goTo(pass);
                fitted.add(levels.triangles());
                pass = Math.max(pass + 1, last(vertices, vertices[pass] / GROWTH));
            }
            levels.goTo(start);
            fitted.add(levels.triangles());
            addStage(fitted, shown, end, source.original(), format);
            end = isFirst ? base + 1 : before;
        }
        return !stages.isEmpty();
    }

    /**
     * Adds the stage before those so far, unless positions in it are exact. With its moves, the level shown at its end
     * is hardly better than with the moves of the next stage.
     */
    private void addStage(List<int[]> fitted, int[] shown, int end, Mesh original, MeshFormat format) {
        double cell = format.cellSize();
        int[] later = stages.isEmpty() ? null : moves();
        double next = fitter.error(shown, later, cell);
        int shift = 0;
        if (!format.hasMirror()) {
            shift = Math.max(precision.ofStage(next / cell), stages.isEmpty() ? 0 : stages.getFirst().shift);
            if (shift == 0) return;
        }
        double[] offset = {format.offset(0), format.offset(1), format.offset(2)};
        UnitGrid grid = new UnitGrid(cell, offset, shift, later);
        while (true) {
            int[] moves = shift == 0 ? fitter.fit(fitted, cell) : fitter.fit(fitted, grid);
            format.mirrorMoves(original, moves);
            if (fitted.size() == 1 || fitter.error(shown, moves, cell) > LEAST_SHARE * next) {
                stages.addFirst(new Stage(moves, end, shift));
                return;
            }
            fitted.remove(0);
        }
    }

    /** Fan vertices before each pass is undone. */
    private static int[] vertices(CodedMesh source) {
        CornerTable t = source.table();
        int count = 0;
        for (int v = 0; v < t.vertices(); v++) if (t.cornerOf(v) >= 0) count++;
        int[] vertices = new int[source.log().passes()];
        for (int pass = vertices.length - 1; pass >= 0; pass--) {
            vertices[pass] = count;
            count += source.log().vertices(pass);
        }
        return vertices;
    }

    /**
     * The last pass, in the order of undoing, before which there are at most so many vertices. If there is none: one
     * more than the first pass to undo.
     */
    private static int last(int[] vertices, double most) {
        int pass = vertices.length;
        while (pass > 0 && vertices[pass - 1] <= most) pass--;
        return pass;
    }
}
