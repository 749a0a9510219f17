package org.jsmesh.mesh.io;

import java.util.Locale;
import java.util.Set;

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
        if (StlReader.hasBinaryLength(content)) return ModelFormat.STL;
        TextScanner scanner = new TextScanner(fileName, content, 0, true, false);
        String word = scanner.next() && scanner.tokenEnd() - scanner.tokenStart() <= LOOK_BYTES ? scanner.token() : "";
        if (word.startsWith("{") && isJson(content)) return ModelFormat.GLB;
        if (OffReader.isKeyword(word)) return ModelFormat.OFF;
        if (word.equalsIgnoreCase("solid")) return ModelFormat.STL;
        if (HOPPE_WORDS.contains(word)) return ModelFormat.HOPPE_M;
        if (OBJ_WORDS.contains(word)) return ModelFormat.OBJ;
        if (isThreeCounts(scanner, word)) return ModelFormat.OFF;
        // the content says nothing; the reader of the name's format then explains what is wrong with the file
        return content.length == 0 ? null : ModelFormat.ofName(fileName);
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
