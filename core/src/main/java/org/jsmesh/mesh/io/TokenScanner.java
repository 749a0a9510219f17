package org.jsmesh.mesh.io;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import org.jsmesh.mesh.Note;

/**
 * Walks over the tokens of a text file without making strings of them. Lines end with LF, CR LF or CR. The current
 * token is {@code [tokenStart, tokenEnd)} of the bytes; places among them hold until the next line.
 */
class TokenScanner extends ByteWindow {
    private static final int LONGEST_QUOTE = 40;

    private final String file;
    private final boolean comments;
    private final boolean continuation;
    private int line = 1;
    private int tokenStart;
    private int tokenEnd;

    /**
     * @param comments whether {@code #} starts a comment that lasts to the end of the line
     * @param continuation whether a backslash at the end of a line joins it with the next
     */
    TokenScanner(String file, byte[] bytes, int start, boolean comments, boolean continuation) {
        super(bytes, start);
        this.file = file;
        this.comments = comments;
        this.continuation = continuation;
    }

    /**
     * Reads the text from its start.
     *
     * @param end place of the first byte that does not count
     */
    TokenScanner(String file, ByteSource source, long end, boolean comments, boolean continuation) {
        super(source, end);
        this.file = file;
        this.comments = comments;
        this.continuation = continuation;
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

    /** Next token of this line; false at its end. */
    boolean nextOnLine() {
        skipBlanks();
        if (!has(position) || isLineEnd(bytes[position])) return false;
        if (comments && bytes[position] == '#') return false; // the next line is looked for without keeping this one
        tokenStart = position;
        do while (position < limit && !endsToken(position)) position++;
        while (position == limit && more());
        tokenEnd = position;
        return true;
    }

    /** Next token of this or a later line; false at the end of the file. */
    boolean next() {
        moveOn();
        while (!nextOnLine()) {
            if (!nextLine()) return false;
        }
        return true;
    }

    @Override
    void moved(int by) {
        tokenStart = Math.max(0, tokenStart - by);
        tokenEnd = Math.max(0, tokenEnd - by);
    }

    /** Goes to the start of the next line; false at the end of the file. */
    boolean nextLine() {
        do while (position < limit && !isLineEnd(bytes[position])) position++;
        while (position == limit && drop());
        if (position == limit) return false;
        boolean carriageReturn = bytes[position++] == '\r';
        if (carriageReturn && has(position) && bytes[position] == '\n') position++;
        line++;
        moveOn();
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
        if (!has(at + text.length() - 1)) return false;
        for (int i = 0; i < text.length(); i++) {
            if (bytes[at + i] != text.charAt(i)) return false;
        }
        return true;
    }

    /** The value of a hexadecimal digit, negative where there is none. */
    int hexDigitAt(int at) {
        return has(at) && bytes[at] >= 0 && bytes[at] < 'g' ? Character.digit(bytes[at], 16) : -1;
    }

    boolean isBlankAt(int at) {
        return has(at) && isBlank(bytes[at]);
    }

    boolean isLineEndAt(int at) {
        return !has(at) || isLineEnd(bytes[at]);
    }

    /** Whether the whole current line, ends trimmed, is this text. */
    boolean lineIs(String text) {
        int start = lineStart();
        int end = start;
        while (has(end) && !isLineEnd(bytes[end])) end++;
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
        while (has(position)) {
            if (isBlank(bytes[position])) {
                position++;
            } else if (continues(position)) {
                position++;
                while (isBlankAt(position)) position++;
                while (has(position) && bytes[position] == '\r') position++;
                if (has(position) && bytes[position] == '\n') position++;
                line++;
            } else {
                return;
            }
        }
    }

    private void skipToLineEnd() {
        do while (position < limit && !isLineEnd(bytes[position])) position++;
        while (position == limit && more());
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
        return at > tokenStart && bytes[at - 1] == '.' && has(at + 1) && "IQSN".indexOf(bytes[at + 1]) >= 0;
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
