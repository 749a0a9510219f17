package org.jsmesh.mesh.io;

import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
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
    private static final int HEAD_BYTES = 1 << 20;

    private FormatSniffer() {}

    /** The first bytes of a file, or all of a file in memory: as many as tell what it is. */
    static byte[] head(ByteSource content) throws IOException {
        if (content instanceof ByteSource.Held held) return held.content();
        byte[] head = new byte[(int) Math.min(HEAD_BYTES, content.length())];
        int size = 0;
        try (InputStream in = content.from(0)) {
            for (int count; size < head.length && (count = in.read(head, size, head.length - size)) >= 0; )
                size += count;
        }
        return size == head.length ? head : Arrays.copyOf(head, size);
    }

    /**
     * @param head as {@link #head} gives it
     * @return the format, or null when it is unknown
     */
    static ModelFormat sniff(String fileName, byte[] head, ByteSource content) throws IOException {
        int start = TokenScanner.afterByteOrderMark(head);
        if (startsWith(head, 0, "glTF")) return ModelFormat.GLB;
        if (startsWith(head, start, "ply") && head.length > start + 3 && head[start + 3] <= ' ') return ModelFormat.PLY;
        if (ZipArchive.isZip(head) && ThreeMfReader.isThreeMf(WholeFile.of(fileName, content)))
            return ModelFormat.THREE_MF;
        if (StlReader.hasBinaryLength(head, content.length())) return ModelFormat.STL;
        TextScanner scanner = new TextScanner(fileName, content, content.length(), true, false);
        scanner.growTo(HEAD_BYTES); // anything may come here
        String word = scanner.next() && scanner.tokenEnd() - scanner.tokenStart() <= LOOK_BYTES ? scanner.token() : "";
        if (word.startsWith("{") && isJson(head)) return ModelFormat.GLB;
        if (OffHeader.isKeyword(word)) return ModelFormat.OFF;
        if (word.equalsIgnoreCase("solid")) return ModelFormat.STL;
        if (HOPPE_WORDS.contains(word)) return ModelFormat.HOPPE_M;
        if (OBJ_WORDS.contains(word)) return ModelFormat.OBJ;
        if (isThreeCounts(scanner, word)) return ModelFormat.OFF;
        if (head.length == 0 || Unpacker.isGzip(head) || ZipArchive.isZip(head)) return null;
        // the content says nothing; the reader of the name's format then explains what is wrong with the file
        return ModelFormat.ofName(fileName);
    }

    /**
     * The name of an encoding with more than a byte per letter, or null when the content is none: by its mark, or by
     * the zeros between the first letters.
     *
     * @param content the head of a file
     * @param length of the file
     */
    static String wideText(byte[] content, long length) {
        if (content.length < 8 || StlReader.hasBinaryLength(content, length)) return null;
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

    /**
     * Whether an STL file is text, though both kinds may start with "solid".
     *
     * @param content the head of the file
     * @param length of the file
     */
    static boolean isTextStl(byte[] content, long length) {
        if (StlReader.hasBinaryLength(content, length)) return false;
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
        return TokenScanner.decode(content, 0, Math.min(content.length, HEAD_BYTES))
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
