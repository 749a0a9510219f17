package org.jsmesh.mesh.io;

import java.util.Locale;
import java.util.Set;
import org.jsmesh.mesh.io.zip.Unpacker;
import org.jsmesh.mesh.io.zip.ZipArchive;

/** Tells the format of a model file from its content; the name decides only where the content leaves it open. */
final class FormatSniffer {
    private static final Set<String> OBJ_WORDS = Set.of(
            "v", "vt", "vn", "vp", "f", "fo", "g", "o", "s", "l", "p", "mtllib", "usemtl", "cstype", "deg", "bevel");
    private static final Set<String> HOPPE_WORDS = Set.of("Vertex", "Face", "Corner", "Edge");
    private static final int LOOK_BYTES = 1000;

    private FormatSniffer() {}

    /** @return the format, or null when it is unknown */
    static ModelFormat sniff(String fileName, byte[] content) {
        int start = TokenScanner.afterByteOrderMark(content);
        if (startsWith(content, 0, "glTF")) return ModelFormat.GLB;
        if (startsWith(content, start, "ply") && content.length > start + 3 && content[start + 3] <= ' ')
            return ModelFormat.PLY;
        if (ThreeMfReader.isThreeMf(content)) return ModelFormat.THREE_MF;
        if (StlReader.hasBinaryLength(content)) return ModelFormat.STL;
        TextScanner scanner = new TextScanner(fileName, content, 0, true, false);
        String word = scanner.next() && scanner.tokenEnd() - scanner.tokenStart() <= LOOK_BYTES ? scanner.token() : "";
        if (word.startsWith("{") && isJson(content)) return ModelFormat.GLB;
        if (OffHeader.isKeyword(word)) return ModelFormat.OFF;
        if (word.equalsIgnoreCase("solid")) return ModelFormat.STL;
        if (HOPPE_WORDS.contains(word)) return ModelFormat.HOPPE_M;
        if (OBJ_WORDS.contains(word)) return ModelFormat.OBJ;
        if (isThreeCounts(scanner, word)) return ModelFormat.OFF;
        if (content.length == 0 || Unpacker.isGzip(content) || ZipArchive.isZip(content)) return null;
        // the content says nothing; the reader of the name's format then explains what is wrong with the file
        return ModelFormat.ofName(fileName);
    }

    /**
     * The name of an encoding with more than a byte per letter, or null when the content is none: by its mark, or by
     * the zeros between the first letters.
     */
    static String wideText(byte[] content) {
        if (content.length < 8 || StlReader.hasBinaryLength(content)) return null;
        int a = content[0] & 0xFF;
        int b = content[1] & 0xFF;
        int c = content[2] & 0xFF;
        int d = content[3] & 0xFF;
        boolean marked32 = a == 0xFF && b == 0xFE && c == 0 && d == 0 || a == 0 && b == 0 && c == 0xFE && d == 0xFF;
        if (marked32) return "UTF-32";
        if (a == 0xFF && b == 0xFE || a == 0xFE && b == 0xFF) return "UTF-16";
        if (hasLettersAt(content, 4, 0) || hasLettersAt(content, 4, 3)) return "UTF-32";
        return hasLettersAt(content, 2, 0) || hasLettersAt(content, 2, 1) ? "UTF-16" : null;
    }

    /** Whether ASCII is at a place of each unit, and zeros at the others. */
    private static boolean hasLettersAt(byte[] content, int unit, int place) {
        for (int i = 0; i < Math.min(content.length / unit, 8) * unit; i++) {
            boolean letter = i % unit == place;
            boolean printable = content[i] >= ' ' && content[i] < 0x7F || content[i] == '\n' || content[i] == '\r';
            if (letter ? !printable && content[i] != '\t' : content[i] != 0) return false;
        }
        return true;
    }

    /** Whether an STL file is text, though both kinds may start with "solid". */
    static boolean isTextStl(byte[] content) {
        if (StlReader.hasBinaryLength(content)) return false;
        int start = TokenScanner.afterByteOrderMark(content);
        while (start < content.length && content[start] <= ' ' && content[start] >= 0) start++;
        int end = Math.min(content.length, start + LOOK_BYTES);
        if (!TokenScanner.decode(content, start, Math.min(end, start + 5))
                .toLowerCase(Locale.ROOT)
                .equals("solid")) return false;
        for (int i = start; i < end; i++) {
            if (content[i] == 0) return false;
        }
        return true;
    }

    private static boolean isJson(byte[] content) {
        return TokenScanner.decode(content, 0, Math.min(content.length, 1 << 20))
                .contains("\"asset\"");
    }

    /** OFF without its keyword: the first line is the three counts. */
    private static boolean isThreeCounts(TextScanner scanner, String word) {
        if (!isCount(word)) return false;
        for (int i = 0; i < 2; i++) {
            if (!scanner.nextOnLine() || !isCount(scanner.token())) return false;
        }
        return !scanner.nextOnLine();
    }

    private static boolean isCount(String word) {
        return word.matches("[0-9]{1,9}");
    }

    private static boolean startsWith(byte[] content, int at, String text) {
        if (content.length < at + text.length()) return false;
        for (int i = 0; i < text.length(); i++) {
            if (content[at + i] != text.charAt(i)) return false;
        }
        return true;
    }
}
