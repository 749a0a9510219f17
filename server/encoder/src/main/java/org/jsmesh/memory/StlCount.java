package org.jsmesh.memory;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.Locale;
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

    /** Whether the count in its header and its length agree, or it has the name and does not look like text. */
    static boolean isBinary(Sampled file) throws IOException {
        if (hasBinaryLength(file)) return true;
        if (file.start().length < HEADER) return false;
        return file.name().toLowerCase(Locale.ROOT).endsWith(".stl") && !isText(file);
    }

    private static boolean hasBinaryLength(Sampled file) throws IOException {
        return file.start().length >= HEADER && file.length() == HEADER + ROW * file.littleEndian(80);
    }

    /** Whether it is text as the reader sees it; files of either kind may start with "solid". */
    static boolean isText(Sampled file) throws IOException {
        if (hasBinaryLength(file)) return false;
        byte[] b = file.start();
        int at = b.length > 2 && (b[0] & 255) == 0xEF && (b[1] & 255) == 0xBB && (b[2] & 255) == 0xBF ? 3 : 0;
        while (at < b.length && b[at] <= ' ' && b[at] >= 0) at++;
        int end = Math.min(b.length, at + LOOK);
        String text = new String(b, at, end - at, StandardCharsets.ISO_8859_1);
        return text.regionMatches(true, 0, "solid", 0, 5) && text.indexOf(0) < 0;
    }

    static ModelCount of(Sampled file) throws IOException {
        double faces = Math.max(0, (file.length() - HEADER) / ROW);
        boolean isSoup = isSoup(file.start());
        double least = hasBinaryLength(file) ? faces : 0; // others are filled up, cut, or something else
        return new ModelCount(faces, least, isSoup ? 3 * faces : faces / 2, 0, file.length(), 0, true, false);
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
