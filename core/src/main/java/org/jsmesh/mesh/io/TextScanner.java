package org.jsmesh.mesh.io;

import java.util.Locale;
import java.util.function.Supplier;

/** Reads the numbers among the tokens of a text file. */
final class TextScanner extends TokenScanner {
    private final Decimal decimal = new Decimal();

    /**
     * @param comments whether {@code #} starts a comment that lasts to the end of the line
     * @param continuation whether a backslash at the end of a line joins it with the next
     */
    TextScanner(String file, byte[] bytes, int start, boolean comments, boolean continuation) {
        super(file, bytes, start, comments, continuation);
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
        if (Float.isInfinite(value))
            throw error(
                    what + where.get() + " is " + quote() + ", beyond the range of float32", "Scale the model down");
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
        if (decimal.scan(bytes, tokenStart(), tokenEnd())) return decimal.toFloat();
        if (namesNonFinite(token())) return Float.NaN;
        throw notANumber(what);
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

    int intOnLine(String what) throws ModelFormatException {
        if (!nextOnLine()) throw error(what + " is missing", "Complete the line");
        return tokenAsInt(what);
    }

    int tokenAsInt(String what) throws ModelFormatException {
        return parseInt(tokenStart(), tokenEnd(), what);
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

    private ModelFormatException notANumber(String what) {
        if (namesNonFinite(token())) {
            return error(
                    what + " is " + quote() + ", not a finite number",
                    "Repair or remove this vertex in the program that wrote the file");
        }
        return error(what + " is " + quote() + ", not a number", "Correct this line");
    }

    /** What C and Microsoft runtimes print for numbers that are not finite. */
    private static boolean namesNonFinite(String token) {
        String word = token.toLowerCase(Locale.ROOT);
        if (word.startsWith("-") || word.startsWith("+")) word = word.substring(1);
        return word.equals("inf") || word.equals("infinity") || word.startsWith("nan") || word.startsWith("1.#");
    }
}
