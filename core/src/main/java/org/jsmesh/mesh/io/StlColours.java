package org.jsmesh.mesh.io;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.jsmesh.mesh.Note;

/**
 * Colours of binary STL, in the two bytes behind each facet. Materialise Magics writes {@code COLOR=} with four bytes
 * into the header: the colour of all facets but those whose word has the highest bit clear, which is then their own
 * (red in the lowest five bits). VisCAM and SolidView write words with the highest bit set (blue in the lowest five
 * bits), and 0 where there is no colour. Other words are no colours.
 */
final class StlColours {
    private static final String HEADER_COLOUR = "COLOR=";
    private static final String HEADER_MATERIAL = "MATERIAL=";
    private static final int MARK = 0x8000;
    private static final int MOST = 31;

    private final int[] words;
    private final float[] common; // red, green, blue, opacity of Magics' header, or null
    private final boolean blank;
    private final boolean marked;

    StlColours(byte[] head, int[] words, List<Note> notes) {
        this.words = words;
        common = common(head);
        boolean anyWord = false;
        boolean allMarked = true;
        for (int word : words) {
            anyWord |= word != 0;
            allMarked &= word == 0 || (word & MARK) != 0;
        }
        blank = !anyWord;
        marked = allMarked;
        if (common != null && header(head).contains(HEADER_MATERIAL))
            notes.add(Note.dropped("The header's specular and ambient colour not kept.", 1, "byte 0"));
    }

    private static String header(byte[] content) {
        return new String(content, 0, StlReader.HEADER_BYTES, StandardCharsets.ISO_8859_1);
    }

    private static float[] common(byte[] content) {
        int at = header(content).indexOf(HEADER_COLOUR);
        if (at < 0 || at + HEADER_COLOUR.length() + 4 > StlReader.HEADER_BYTES) return null;
        float[] rgba = new float[4];
        for (int i = 0; i < 4; i++) rgba[i] = (content[at + HEADER_COLOUR.length() + i] & 0xFF) / 255f;
        return rgba;
    }

    /** Whether the words are colours, or the header has one. */
    boolean any() {
        return common != null || !blank && marked;
    }

    /** Whether there are words that mean something else. */
    boolean areOther() {
        return !blank && !any();
    }

    /** The colour of a facet, as {@link FaceColours#add} gives it. */
    int add(int facet, FaceColours colours) {
        int word = words[facet];
        if (common != null && (blank || (word & MARK) != 0))
            return colours.add(-1, FaceColours.Range.DECIMAL, common[3] == 1 ? 3 : 4, common);
        if (common == null && (word & MARK) == 0) return -1;
        float low = (word & MOST) / (float) MOST;
        float middle = (word >> 5 & MOST) / (float) MOST;
        float high = (word >> 10 & MOST) / (float) MOST;
        float[] rgb = common != null ? new float[] {low, middle, high} : new float[] {high, middle, low};
        return colours.add(-1, FaceColours.Range.DECIMAL, 3, rgb);
    }

    /** The word of VisCAM for a colour. */
    static int word(float[] rgb) {
        int word = MARK;
        for (int i = 0; i < 3; i++) word |= Math.round(MOST * Math.max(0, Math.min(1, rgb[i]))) << 5 * (2 - i);
        return word;
    }

    /** Whether such a word holds a colour exactly. */
    static boolean isExact(float[] rgb) {
        for (float value : rgb) {
            if (!FaceColour.isPart(value, MOST)) return false;
        }
        return true;
    }

    /** Writes a colour into a header that has room for it. */
    static void write(byte[] header, int at, float[] rgba) {
        ByteBuffer out = ByteBuffer.wrap(header).order(ByteOrder.LITTLE_ENDIAN).position(at);
        out.put(HEADER_COLOUR.getBytes(StandardCharsets.US_ASCII));
        for (int i = 0; i < 4; i++) out.put((byte) Math.round(255 * rgba[i]));
    }
}
