package org.jsmesh.archive;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.codec.CodedMesh;
import org.jsmesh.codec.MeshCoder;
import org.jsmesh.codec.MeshFormat;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.patch.PatchLog;

/** Where the vertices of coarse levels are shown until they are brought back to where they belong. */
public final class CoarseFit {
    /** Vertices are brought back when more than this share of them all comes: later it would cost more than it gains. */
    private static final double SHARE = 0.085;

    /** And when more than this comes, because fitting takes time. */
    private static final int MOST_VERTICES = 40_000;

    private static final double GROWTH = 2; // of vertices, from one level that is fitted to the next

    private final Fitter fitter;
    private int lastPass;

    /** Fits levels of detail to their original. */
    public interface Fitter {
        /**
         * @param levels three vertices of the original per triangle, coarsest level first; the fitter may overwrite them
         * @param unit length in which to measure moves
         * @return the moves of all vertices along x, y, z
         */
        int[] fit(List<int[]> levels, double unit);
    }

    CoarseFit(Fitter fitter) {
        this.fitter = fitter;
    }

    /** The pass of the log before which vertices are brought back; those of greater number go before it. */
    int lastPass() {
        return lastPass;
    }

    /** Cells by which to move the vertices of the original along x, y, z; null where none are worth it. */
    int[] cells(CodedMesh source, MeshFormat format, int shift) throws MalformedStreamException {
        List<int[]> levels = levels(source, format, shift);
        return levels.isEmpty() ? null : fitter.fit(levels, format.cellSize());
    }

    /** The levels up to the one where vertices are brought back, as a coder will come to them. */
    private List<int[]> levels(CodedMesh source, MeshFormat format, int shift) throws MalformedStreamException {
        List<int[]> levels = new ArrayList<>();
        double most = Math.min(MOST_VERTICES, SHARE * source.original().vertices());
        MeshCoder scout = MeshCoder.encoder(format, source);
        scout.setPrecision(shift);
        scout.codeBase(new SplitPayload(scout.hasAttributes()).streams(), 0, 0);
        if (scout.vertices() > most) return levels;
        PatchLog log = source.log();
        int fitted = 0;
        for (lastPass = log.passes() - 1; lastPass >= 0; lastPass--) {
            int splits = log.passStart(lastPass + 1) - log.passStart(lastPass);
            boolean isLast = scout.vertices() + splits > most;
            if (isLast || scout.vertices() >= GROWTH * fitted) {
                levels.add(triangles(scout.exactly(source.original())));
                fitted = scout.vertices();
            }
            if (isLast) break;
            scout.beginPass(lastPass);
            scout.codeSplits(new SplitPayload(scout.hasAttributes()).streams(), splits);
        }
        return levels;
    }

    private static int[] triangles(Mesh level) {
        int[] triangles = new int[3 * level.faces()];
        for (int i = 0; i < triangles.length; i++) triangles[i] = level.vertex(i / 3, i % 3);
        return triangles;
    }
}
