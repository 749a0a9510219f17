package org.jsmesh.mesh.io;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;

/**
 * Walks over the tokens of a text file without making strings of them. Lines end with LF, CR LF or CR. The current token is
 * {@code [tokenStart, tokenEnd)} of the bytes.
 */
final class TextScanner {
    private static final int LONGEST_QUOTE = 40;

    private final String file;
    private final byte[] bytes;
    private final boolean comments;
    private final boolean continuation;
    private final Decimal decimal = new Decimal();
    private int position;
    private int line = 1;
    private int tokenStart;
    private int tokenEnd;

    /**
     * @param comments whether {@code #} starts a comment that lasts to the end of the line
     * @param continuation whether a backslash at the end of a line joins it with the next
     */
    TextScanner(String file, byte[] bytes, int start, boolean comments, boolean continuation) {
        this.file = file;
        this.bytes = bytes;
        this.comments = comments;
        this.continuation = continuation;
        position = start == 0 ? afterByteOrderMark(bytes) : start;
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
        while (position < bytes.length && !endsToken(bytes[position])) position++;
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
        int length = word.length();
        if (tokenEnd - tokenStart != length) return false;
        for (int i = 0; i < length; i++) {
            if (bytes[tokenStart + i] != word.charAt(i)) return false;
        }
        return true;
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

    /** The next token of this line as a finite float32. */
    float floatOnLine(String what) throws ModelFormatException {
        if (!nextOnLine()) throw error(what + " is missing", "Complete the line");
        return tokenAsFloat(what);
    }

    /** The current token as a finite float32. */
    float tokenAsFloat(String what) throws ModelFormatException {
        if (!decimal.scan(bytes, tokenStart, tokenEnd)) throw notANumber(what);
        float value = decimal.toFloat();
        if (Float.isInfinite(value))
            throw error(what + " is " + quote() + ", beyond the range of float32", "Scale the model down");
        return value;
    }

    /** The current token as float64, NaN and infinity included when the text names them. */
    double tokenAsDouble(String what) throws ModelFormatException {
        if (decimal.scan(bytes, tokenStart, tokenEnd)) return decimal.toDouble();
        if (namesNonFinite(token())) return Double.NaN;
        throw notANumber(what);
    }

    /** The current token as float32, not finite when the text says so or is too large. */
    float tokenAsAnyFloat(String what) throws ModelFormatException {
        if (decimal.scan(bytes, tokenStart, tokenEnd)) return decimal.toFloat();
        if (namesNonFinite(token())) return Float.NaN;
        throw notANumber(what);
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

    /** Whether the whole current line, ends trimmed, is this text. */
    boolean lineIs(String text) {
        int start = position;
        while (start > 0 && !isLineEnd(bytes[start - 1])) start--;
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

    String lowerCaseToken() {
        return token().toLowerCase(Locale.ROOT);
    }

    boolean tokenHasControlCharacter() {
        for (int i = tokenStart; i < tokenEnd; i++) {
            if (bytes[i] >= 0 && bytes[i] < ' ') return true;
        }
        return false;
    }

    /** The number that {@link #tokenIsNumber} found, perhaps infinite. */
    float number() {
        return decimal.toFloat();
    }

    boolean tokenIsNumber() {
        return decimal.scan(bytes, tokenStart, tokenEnd);
    }

    /** Whether the number read last had neither point nor exponent. */
    boolean numberWasInteger() {
        return decimal.isInteger();
    }

    int intOnLine(String what) throws ModelFormatException {
        if (!nextOnLine()) throw error(what + " is missing", "Complete the line");
        return tokenAsInt(what);
    }

    int tokenAsInt(String what) throws ModelFormatException {
        return parseInt(tokenStart, tokenEnd, what);
    }

    /** The bytes {@code [start, end)} as an int with an optional sign. */
    int parseInt(int start, int end, String what) throws ModelFormatException {
        int at = start;
        boolean negative = at < end && bytes[at] == '-';
        if (at < end && (bytes[at] == '-' || bytes[at] == '+')) at++;
        long value = 0;
        boolean valid = at < end;
        for (; at < end && valid; at++) {
            int digit = bytes[at] - '0';
            valid = digit >= 0 && digit <= 9;
            value = 10 * value + digit;
            if (value > Integer.MAX_VALUE) valid = false;
        }
        if (!valid) throw error(what + " is " + quote() + ", not a whole number in range", "Correct this line");
        return (int) (negative ? -value : value);
    }

    ModelFormatException error(String reason, String remedy) {
        return new ModelFormatException(file, "line " + line, reason, remedy);
    }

    private ModelFormatException notANumber(String what) {
        if (namesNonFinite(token())) {
            return error(
                    what + " is " + quote() + ", not a finite number",
                    "Repair or remove this vertex in the program that wrote the file");
        }
        return error(what + " is " + quote() + ", not a number", "Correct this line");
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

    /** What C and Microsoft runtimes print for numbers that are not finite. */
    private static boolean namesNonFinite(String token) {
        String word = token.toLowerCase(Locale.ROOT);
        if (word.startsWith("-") || word.startsWith("+")) word = word.substring(1);
        return word.equals("inf") || word.equals("infinity") || word.startsWith("nan") || word.startsWith("1.#");
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

    private boolean endsToken(byte b) {
        return isBlank(b) || isLineEnd(b) || comments && b == '#' || b == '\\' && continues(position);
    }

    private boolean continues(int at) {
        if (!continuation || bytes[at] != '\\') return false;
        return at + 1 == bytes.length || isLineEnd(bytes[at + 1]);
    }

    private static boolean isLineEnd(byte b) {
        return b == '\n' || b == '\r';
    }

    private static boolean isBlank(byte b) {
        return b == ' ' || b == '\t' || b == 0x0B || b == '\f';
    }
}
