package org.jsmesh.mesh.io;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.jsmesh.mesh.Note;

/**
 * Walks over the tokens of a text file without making strings of them. Lines end with LF, CR LF or CR. The current
 * token is {@code [tokenStart, tokenEnd)} of the bytes.
 */
class TokenScanner {
    private static final int LONGEST_QUOTE = 40;

    private final String file;
    final byte[] bytes; // of the whole file
    private final boolean comments;
    private final boolean continuation;
    private int position;
    private int line = 1;
    private int tokenStart;
    private int tokenEnd;

    /**
     * @param comments whether {@code #} starts a comment that lasts to the end of the line
     * @param continuation whether a backslash at the end of a line joins it with the next
     */
    TokenScanner(String file, byte[] bytes, int start, boolean comments, boolean continuation) {
        this.file = file;
        this.bytes = bytes;
        this.comments = comments;
        this.continuation = continuation;
        position = start == 0 ? afterByteOrderMark(bytes) : start;
    }

    /** The bytes without the NULs and the end-of-file character that some programs fill a text file up with. */
    static byte[] withoutFilling(byte[] bytes) {
        int end = bytes.length;
        while (end > 0 && (bytes[end - 1] == 0 || bytes[end - 1] == 0x1A)) end--;
        return end == bytes.length ? bytes : Arrays.copyOf(bytes, end);
    }

    static int afterByteOrderMark(byte[] bytes) {
        boolean marked =
                bytes.length >= 3 && bytes[0] == (byte) 0xEF && bytes[1] == (byte) 0xBB && bytes[2] == (byte) 0xBF;
        return marked ? 3 : 0;
    }

    int line() {
        return line;
    }

    void countLinesFrom(int firstLine) {
        line = firstLine;
    }

    int position() {
        return position;
    }

    int remaining() {
        return bytes.length - position;
    }

    /** Next token of this line; false at its end. */
    boolean nextOnLine() {
        skipBlanks();
        if (position == bytes.length || isLineEnd(bytes[position])) return false;
        if (comments && bytes[position] == '#') {
            skipToLineEnd();
            return false;
        }
        tokenStart = position;
        while (position < bytes.length && !endsToken(position)) position++;
        tokenEnd = position;
        return true;
    }

    /** Next token of this or a later line; false at the end of the file. */
    boolean next() {
        while (!nextOnLine()) {
            if (!nextLine()) return false;
        }
        return true;
    }

    /** Goes to the start of the next line; false at the end of the file. */
    boolean nextLine() {
        skipToLineEnd();
        if (position == bytes.length) return false;
        boolean carriageReturn = bytes[position++] == '\r';
        if (carriageReturn && position < bytes.length && bytes[position] == '\n') position++;
        line++;
        return true;
    }

    /** What is left of this line, comments included, without blanks around it. */
    String restOfLine() {
        skipBlanks();
        int start = position;
        skipToLineEnd();
        int end = position;
        while (end > start && isBlank(bytes[end - 1])) end--;
        return decode(bytes, start, end);
    }

    boolean tokenIs(String word) {
        return tokenEnd - tokenStart == word.length() && hasAt(tokenStart, word);
    }

    String token() {
        return decode(bytes, tokenStart, tokenEnd);
    }

    int tokenStart() {
        return tokenStart;
    }

    int tokenEnd() {
        return tokenEnd;
    }

    byte byteAt(int offset) {
        return bytes[offset];
    }

    /** Goes back to an earlier position of this line. */
    void backTo(int earlier) {
        position = earlier;
    }

    /** Whether only blanks or a comment follow on this line. */
    boolean atLineEnd() {
        int before = position;
        boolean end = !nextOnLine();
        position = before;
        return end;
    }

    /** Where the current line starts. */
    int lineStart() {
        int start = position;
        while (start > 0 && !isLineEnd(bytes[start - 1])) start--;
        return start;
    }

    /** Whether the bytes at a place are these characters of ASCII. */
    boolean hasAt(int at, String text) {
        if (bytes.length - at < text.length()) return false;
        for (int i = 0; i < text.length(); i++) {
            if (bytes[at + i] != text.charAt(i)) return false;
        }
        return true;
    }

    /** The value of a hexadecimal digit, negative where there is none. */
    int hexDigitAt(int at) {
        return at < bytes.length && bytes[at] >= 0 && bytes[at] < 'g' ? Character.digit(bytes[at], 16) : -1;
    }

    boolean isBlankAt(int at) {
        return at < bytes.length && isBlank(bytes[at]);
    }

    boolean isLineEndAt(int at) {
        return at >= bytes.length || isLineEnd(bytes[at]);
    }

    /** Whether the whole current line, ends trimmed, is this text. */
    boolean lineIs(String text) {
        int start = lineStart();
        int end = start;
        while (end < bytes.length && !isLineEnd(bytes[end])) end++;
        return end - start == text.length() && decode(bytes, start, end).equals(text);
    }

    /** Counts without moving on. */
    int tokensLeftOnLine() {
        int before = position;
        int tokens = 0;
        while (nextOnLine()) tokens++;
        position = before;
        return tokens;
    }

    /** Tells of lines with tokens behind the current token, where an element of the file was the last. */
    void noteRest(String element, List<Note> notes) {
        if (!next()) return;
        int first = line;
        int rows = 1;
        while (nextLine()) {
            if (nextOnLine()) rows++;
        }
        String text = Notes.count(rows, "row") + " behind the last " + element + " skipped.";
        notes.add(Note.unread(text, rows, "line " + first));
    }

    String lowerCaseToken() {
        return token().toLowerCase(Locale.ROOT);
    }

    boolean tokenHasControlCharacter() {
        for (int i = tokenStart; i < tokenEnd; i++) {
            if (bytes[i] >= 0 && bytes[i] < ' ') return true;
        }
        return false;
    }

    ModelFormatException error(String reason, String remedy) {
        return new ModelFormatException(file, "line " + line, reason, remedy);
    }

    /** The current token for a message: short, and without control characters. */
    String quote() {
        return quote(token());
    }

    static String quote(String text) {
        String shown = text.length() > LONGEST_QUOTE ? text.substring(0, LONGEST_QUOTE) + "…" : text;
        StringBuilder clean = new StringBuilder("\"");
        for (int i = 0; i < shown.length(); i++)
            clean.append(Character.isISOControl(shown.charAt(i)) ? '?' : shown.charAt(i));
        return clean.append('"').toString();
    }

    /** UTF-8, or Latin-1 where the bytes are not that. */
    static String decode(byte[] bytes, int start, int end) {
        try {
            return StandardCharsets.UTF_8
                    .newDecoder()
                    .decode(ByteBuffer.wrap(bytes, start, end - start))
                    .toString();
        } catch (CharacterCodingException e) {
            return new String(bytes, start, end - start, StandardCharsets.ISO_8859_1);
        }
    }

    private void skipBlanks() {
        while (position < bytes.length) {
            if (isBlank(bytes[position])) {
                position++;
            } else if (continues(position)) {
                position++;
                while (isBlankAt(position)) position++;
                while (position < bytes.length && bytes[position] == '\r') position++;
                if (position < bytes.length && bytes[position] == '\n') position++;
                line++;
            } else {
                return;
            }
        }
    }

    private void skipToLineEnd() {
        while (position < bytes.length && !isLineEnd(bytes[position])) position++;
    }

    private boolean endsToken(int at) {
        byte b = bytes[at];
        return isBlank(b)
                || isLineEnd(b)
                || comments && b == '#' && !isNameOfNoNumber(at)
                || b == '\\' && continues(at);
    }

    /** Whether # is part of what Microsoft's runtimes print for numbers that are none, such as {@code 1.#QNAN}. */
    private boolean isNameOfNoNumber(int at) {
        return at > tokenStart && bytes[at - 1] == '.' && at + 1 < bytes.length && "IQSN".indexOf(bytes[at + 1]) >= 0;
    }

    private boolean continues(int at) {
        if (!continuation || bytes[at] != '\\') return false;
        int next = at + 1;
        while (isBlankAt(next)) next++;
        return isLineEndAt(next);
    }

    private static boolean isLineEnd(byte b) {
        return b == '\n' || b == '\r';
    }

    private static boolean isBlank(byte b) {
        return b == ' ' || b == '\t' || b == 0x0B || b == '\f';
    }
}
