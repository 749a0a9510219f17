package org.jsmesh.memory;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.HashSet;
import java.util.Set;

/** Counts the triangles of a binary STL file by its length, and looks at some of them: do they share corners? */
final class StlCount {
    private static final int HEADER = 84;
    private static final int ROW = 50;
    private static final int CORNERS_AT = 12;

    /** Different corners by triangle, among so many that follow each other; surfaces have one to two. */
    private static final double SEPARATE = 2.9;

    private static final int LOOK = 1000;

    private StlCount() {}

    static boolean isBinary(Sampled file) throws IOException {
        if (file.start().length < HEADER) return false;
        if (file.length() == HEADER + ROW * file.littleEndian(80)) return true;
        return file.name().toLowerCase(java.util.Locale.ROOT).endsWith(".stl") && !file.startsWith("solid");
    }

    static ModelCount of(Sampled file) throws IOException {
        double faces = Math.max(0, (file.length() - HEADER) / ROW);
        boolean isSoup = isSoup(file.start());
        return new ModelCount(faces, faces, isSoup ? 3 * faces : faces / 2, 0, file.length(), 0, true, false);
    }

    private static boolean isSoup(byte[] start) {
        ByteBuffer rows = ByteBuffer.wrap(start).order(ByteOrder.LITTLE_ENDIAN);
        Set<String> corners = new HashSet<>();
        int n = 0;
        for (int at = HEADER; at + ROW <= start.length && n < LOOK; at += ROW, n++) {
            for (int c = at + CORNERS_AT; c < at + ROW - 2; c += 12)
                corners.add(rows.getInt(c) + " " + rows.getInt(c + 4) + " " + rows.getInt(c + 8));
        }
        return n > 1 && corners.size() > SEPARATE * n;
    }
}
