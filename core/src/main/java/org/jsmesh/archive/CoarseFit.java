package org.jsmesh.archive;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.jsmesh.codec.CodedMesh;
import org.jsmesh.codec.MeshCoder;
import org.jsmesh.codec.MeshFormat;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.patch.PatchLog;

/**
 * Where the vertices of coarse levels are shown until they are brought back to where they belong. There are stages: from one to the next, all vertices move to where their surfaces
 * are closest to the original in the levels of the next.
 */
public final class CoarseFit {
    /** Vertices are brought back when more than this share of them all comes: later it would cost more than it gains. */
    private static final double SHARE = 0.12;

    /** And when more than this comes, because fitting takes time. */
    private static final int MOST_VERTICES = 40_000;

    /** Vertices at the end of a stage, in parts of those at the end of the one before. One place for a vertex cannot be the best for all levels. */
    private static final double STAGE_GROWTH = 4;

    private static final double GROWTH = 2; // of vertices, from one level that is fitted to the next

    private final Fitter fitter;
    private final Deque<Stage> stages = new ArrayDeque<>();

    /** Fits levels of detail to their original. */
    public interface Fitter {
        /**
         * @param levels three vertices of the original per triangle, coarsest level first; the fitter may overwrite them
         * @param unit length in which to measure moves
         * @return the moves of all vertices along x, y, z
         */
        int[] fit(List<int[]> levels, double unit);
    }

    /** Moves in cells, and the pass of the log before which the stage ends. */
    private record Stage(int[] moves, int lastPass) {}

    CoarseFit(Fitter fitter) {
        this.fitter = fitter;
    }

    /** The pass of the log before which the present stage ends; those of greater number go before it. */
    int lastPass() {
        return stages.getFirst().lastPass;
    }

    /** Cells by which to move the vertices of the original along x, y, z in the present stage. */
    int[] moves() {
        return stages.getFirst().moves;
    }

    /** Goes on to the next stage; false when there is none, and vertices come back. */
    boolean next() {
        stages.removeFirst();
        return !stages.isEmpty();
    }

    /** Finds all moves, for the levels as a coder will come to them. False where none are worth it. */
    boolean find(CodedMesh source, MeshFormat format, int shift) throws MalformedStreamException {
        MeshCoder scout = MeshCoder.encoder(format, source);
        scout.setPrecision(shift);
        scout.codeBase(new SplitPayload(scout.hasAttributes()).streams(), 0, 0);
        double most = Math.min(MOST_VERTICES, SHARE * source.original().vertices());
        if (scout.vertices() > most) return false;
        double end = firstEnd(scout.vertices(), most);
        PatchLog log = source.log();
        List<int[]> levels = new ArrayList<>();
        int fitted = 0;
        for (int pass = log.passes() - 1; pass >= 0; pass--) {
            int after = scout.vertices() + log.vertices(pass);
            if (after > end || scout.vertices() >= GROWTH * fitted) {
                levels.add(scout.exactSurface(source.original()).triangles());
                fitted = scout.vertices();
            }
            if (after > end) {
                stages.add(new Stage(moves(source, format, levels), pass));
                if (after > most) break;
                levels.clear();
                fitted = 0;
                while (end < after) end *= STAGE_GROWTH;
            }
            scout.beginPass(pass);
            scout.codeSplits(new SplitPayload(scout.hasAttributes()).streams(), log.steps(pass));
        }
        return !stages.isEmpty();
    }

    /** Vertices at the end of the first stage: such that the last one ends with {@code most}. */
    private static double firstEnd(int vertices, double most) {
        double end = most;
        while (end > 1.5 * STAGE_GROWTH * vertices) end /= STAGE_GROWTH;
        return end;
    }

    private int[] moves(CodedMesh source, MeshFormat format, List<int[]> levels) {
        int[] moves = fitter.fit(levels, format.cellSize());
        format.mirrorMoves(source.original(), moves);
        return moves;
    }
}
