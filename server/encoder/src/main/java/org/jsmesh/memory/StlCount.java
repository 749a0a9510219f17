package org.jsmesh.memory;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.Locale;
import java.util.Set;

/**
 * Counts the triangles of a binary STL file by its length, and looks at some of them: do they share corners, and have
 * they colours?
 */
final class StlCount {
    private static final int HEADER = 84;
    private static final int ROW = 50;
    private static final int CORNERS_AT = 12;

    // Different corners by triangle, among so many that follow each other; surfaces have one to two.
    private static final double SEPARATE = 2.9;
    private static final double PAIRS = 1.95; // as in pairs that share no vertex with others

    private static final int LOOK = 1000;

    private static final int COLOUR_VALUES = 3;
    private static final int MARK = 0x8000;

    private final Set<Integer> colours = new HashSet<>(); // words, 0 where there is none
    private boolean hasOtherWords;

    /** Whether the count in its header and its length agree, or it has the name and does not look like text. */
    static boolean isBinary(Sampled file) throws IOException {
        if (hasBinaryLength(file)) return true;
        if (file.start().length < HEADER) return false;
        return file.name().toLowerCase(Locale.ROOT).endsWith(".stl") && !isText(file);
    }

    /** What a binary file has that begins so, or −1 where there is no header. */
    static long length(byte[] start) {
        if (start.length < HEADER) return -1;
        ByteBuffer header = ByteBuffer.wrap(start).order(ByteOrder.LITTLE_ENDIAN);
        return HEADER + ROW * Integer.toUnsignedLong(header.getInt(HEADER - 4));
    }

    private static boolean hasBinaryLength(Sampled file) throws IOException {
        return file.length() == length(file.start());
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
        double vertices = faces * places(cornersByFace(file.start()));
        double least = hasBinaryLength(file) ? faces : 0; // others are filled up, cut, or something else
        StlCount count = new StlCount();
        count.lookForColours(file);
        boolean hasColours = !count.hasOtherWords && count.colours.size() > 1;
        boolean atCorners = hasColours && count.colours.size() > ModelCount.PARTS;
        return new ModelCount(
                faces,
                least,
                vertices,
                atCorners ? 3 * faces : 0,
                atCorners ? COLOUR_VALUES : 0,
                file.length(),
                0,
                true,
                hasColours && !atCorners);
    }

    /** In the words behind the triangles. Where the first ones have some, others all over the file are looked at. */
    private void lookForColours(Sampled file) throws IOException {
        String header = new String(file.start(), StandardCharsets.ISO_8859_1);
        boolean isMagics =
                header.substring(0, Math.min(HEADER, header.length())).contains("COLOR=");
        look(file.start(), HEADER, isMagics);
        boolean none = !isMagics && colours.equals(Set.of(0));
        if (none || colours.size() > ModelCount.PARTS || hasOtherWords) return;
        double step = (double) (file.length() - HEADER) / ROW / (file.samples() + 1);
        for (int part = 1; part <= file.samples(); part++)
            look(file.read(HEADER + ROW * (long) (part * step), ROW * LOOK / file.samples()), 0, isMagics);
    }

    /** Of Magics a word with the mark stands for the colour in the header, of others one without for none. */
    private void look(byte[] rows, int from, boolean isMagics) {
        for (int at = from; at + ROW <= rows.length; at += ROW) {
            int word = rows[at + ROW - 2] & 255 | (rows[at + ROW - 1] & 255) << 8;
            boolean isMarked = (word & MARK) != 0;
            colours.add(isMagics && isMarked ? MARK : word);
            hasOtherWords |= !isMagics && !isMarked && word != 0;
        }
    }

    /**
     * {@return vertices for each face}
     *
     * @param corners that differ, for each face of a sample
     */
    static double places(double corners) {
        if (corners > SEPARATE) return 3;
        return corners > PAIRS ? 2 : .5;
    }

    private static double cornersByFace(byte[] start) {
        ByteBuffer rows = ByteBuffer.wrap(start).order(ByteOrder.LITTLE_ENDIAN);
        Set<String> corners = new HashSet<>();
        int n = 0;
        for (int at = HEADER; at + ROW <= start.length && n < LOOK; at += ROW, n++) {
            for (int c = at + CORNERS_AT; c < at + ROW - 2; c += 12)
                corners.add(rows.getInt(c) + " " + rows.getInt(c + 4) + " " + rows.getInt(c + 8));
        }
        return n > 2 ? (double) corners.size() / n : 0;
    }
}
