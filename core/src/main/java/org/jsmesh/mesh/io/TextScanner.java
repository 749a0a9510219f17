package org.jsmesh.mesh.io;

import java.util.Locale;
import java.util.function.Supplier;
import org.jsmesh.mesh.Sizes;
import org.jsmesh.mesh.TooLargeException;

/** Reads the numbers among the tokens of a text file. */
final class TextScanner extends TokenScanner {
    /** What {@link #wholeNumber} gives for anything else. */
    static final int NO_NUMBER = Integer.MIN_VALUE;

    private final Decimal decimal = new Decimal();

    /**
     * @param comments whether {@code #} starts a comment that lasts to the end of the line
     * @param continuation whether a backslash at the end of a line joins it with the next
     */
    TextScanner(String file, byte[] bytes, int start, boolean comments, boolean continuation) {
        super(file, bytes, start, comments, continuation);
    }

    /**
     * Reads the text from its start.
     *
     * @param end place of the first byte that does not count
     */
    TextScanner(String file, ByteSource source, long end, boolean comments, boolean continuation) {
        super(file, source, end, comments, continuation);
    }

    /** Adds the next token of this line as a coordinate. */
    void coordinateOnLine(String what, Coordinates to) throws ModelFormatException {
        if (!nextOnLine()) throw error(what + " is missing", "Complete the line");
        tokenAsCoordinate(what, () -> "", to);
    }

    /** Adds the current token as a coordinate; {@code where} gives the rest of a message if one is needed. */
    void tokenAsCoordinate(String what, Supplier<String> where, Coordinates to) throws ModelFormatException {
        tokenAsFloat(what, where);
        to.add(decimal);
    }

    /**
     * Adds the current token as a coordinate, or 0 where it is no finite float32.
     *
     * @return whether it is
     */
    boolean tokenAsCoordinateOrNone(String what, Supplier<String> where, Coordinates to) throws ModelFormatException {
        boolean finite = Float.isFinite(tokenAsAnyFloat(what, where));
        if (finite) to.add(decimal);
        else to.addZero();
        return finite;
    }

    /** What to say of a current token that is no finite float32. */
    ModelFormatException refusal(String what) {
        if (!decimal.scan(bytes, tokenStart(), tokenEnd())) return notANumber(what);
        return error(what + " is " + quote() + ", beyond the range of float32", "Scale the model down");
    }

    /** Sets a coordinate to the current token where that is a finite float32; returns the token's number. */
    double tokenAsAnyCoordinate(String what, int index, Coordinates to) throws ModelFormatException {
        float value = tokenAsAnyFloat(what);
        if (Float.isFinite(value)) to.set(index, decimal);
        return value;
    }

    /** The next token of this line as a finite float32. */
    float floatOnLine(String what) throws ModelFormatException {
        if (!nextOnLine()) throw error(what + " is missing", "Complete the line");
        return tokenAsFloat(what);
    }

    /** The current token as a finite float32. */
    float tokenAsFloat(String what) throws ModelFormatException {
        return tokenAsFloat(what, () -> "");
    }

    /** The same; {@code where} gives the rest of a message if one is needed. */
    float tokenAsFloat(String what, Supplier<String> where) throws ModelFormatException {
        if (!decimal.scan(bytes, tokenStart(), tokenEnd())) throw notANumber(what + where.get());
        float value = decimal.toFloat();
        if (Float.isInfinite(value)) throw refusal(what + where.get());
        return value;
    }

    /** The current token as float64, NaN and infinity included when the text names them. */
    double tokenAsDouble(String what) throws ModelFormatException {
        if (decimal.scan(bytes, tokenStart(), tokenEnd())) return decimal.toDouble();
        if (namesNonFinite(token())) return Double.NaN;
        throw notANumber(what);
    }

    /** The current token as float32, not finite when the text says so or is too large. */
    float tokenAsAnyFloat(String what) throws ModelFormatException {
        return tokenAsAnyFloat(what, () -> "");
    }

    /** The same; {@code where} gives the rest of a message if one is needed. */
    float tokenAsAnyFloat(String what, Supplier<String> where) throws ModelFormatException {
        if (decimal.scan(bytes, tokenStart(), tokenEnd())) return decimal.toFloat();
        if (namesNonFinite(token())) return Float.NaN;
        throw notANumber(what + where.get());
    }

    /** The current token as float32, not finite when it is no number of that range. */
    float tokenAsFloatOrNaN() {
        return decimal.scan(bytes, tokenStart(), tokenEnd()) ? decimal.toFloat() : Float.NaN;
    }

    /** The number that {@link #tokenIsNumber} found, perhaps infinite. */
    float number() {
        return decimal.toFloat();
    }

    boolean tokenIsNumber() {
        return decimal.scan(bytes, tokenStart(), tokenEnd());
    }

    /** Whether the number read last had neither point nor exponent. */
    boolean numberWasInteger() {
        return decimal.isInteger();
    }

    /** Refuses the next token of this line where it is a whole number that is no int. */
    void checkCount(String what) throws ModelFormatException {
        int before = position;
        if (nextOnLine() && tokenIsNumber() && numberWasInteger() && tokenAsDouble(what) > Sizes.MOST)
            throw error(token() + " " + what + " are more than fit into memory as one model", TooLargeException.REMEDY);
        position = before;
    }

    int intOnLine(String what) throws ModelFormatException {
        if (!nextOnLine()) throw error(what + " is missing", "Complete the line");
        return tokenAsInt(what);
    }

    int tokenAsInt(String what) throws ModelFormatException {
        return parseInt(tokenStart(), tokenEnd(), what);
    }

    /** The bytes {@code [start, end)} as an int with an optional sign. */
    int parseInt(int start, int end, String what) throws ModelFormatException {
        int value = wholeNumber(start, end);
        if (value == NO_NUMBER)
            throw error(what + " is " + quote() + ", not a whole number in range", "Correct this line");
        return value;
    }

    /** The same; {@link #NO_NUMBER} where the bytes are no whole number of 31 bits. */
    int wholeNumber(int start, int end) {
        int at = start;
        boolean negative = at < end && bytes[at] == '-';
        if (at < end && (bytes[at] == '-' || bytes[at] == '+')) at++;
        if (at == end) return NO_NUMBER;
        long value = 0;
        for (; at < end; at++) {
            int digit = bytes[at] - '0';
            value = 10 * value + digit;
            if (digit < 0 || digit > 9 || value > Integer.MAX_VALUE) return NO_NUMBER;
        }
        return (int) (negative ? -value : value);
    }

    private ModelFormatException notANumber(String what) {
        if (namesNonFinite(token())) {
            return error(
                    what + " is " + quote() + ", not a finite number",
                    "Repair or remove this vertex in the program that wrote the file");
        }
        return error(what + " is " + quote() + ", not a number", "Correct this line");
    }

    /** What C and Microsoft runtimes print for numbers that are not finite. */
    static boolean namesNonFinite(String token) {
        String word = token.toLowerCase(Locale.ROOT);
        if (word.startsWith("-") || word.startsWith("+")) word = word.substring(1);
        return word.equals("inf") || word.equals("infinity") || word.startsWith("nan") || word.startsWith("1.#");
    }
}
