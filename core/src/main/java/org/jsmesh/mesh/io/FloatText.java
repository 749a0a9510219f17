package org.jsmesh.mesh.io;

import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.charset.StandardCharsets;

/** Text of floats that reads back to the same bits. */
final class FloatText {
    private static final MathContext NINE_DIGITS = new MathContext(9);

    private FloatText() {}

    /** As {@link Float#toString(float)}, whole numbers without {@code .0}; −0.0 keeps its sign. */
    static String plain(float value) {
        String text = Float.toString(value);
        Decimal decimal = new Decimal();
        byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
        if (decimal.scan(bytes, 0, bytes.length) && !decimal.isHeldByFloat()) // before Java 19, a digit may be wrong
        return new BigDecimal(value).round(NINE_DIGITS).toString();
        return withoutZero(text);
    }

    /** The same for float64. */
    static String plain(double value) {
        return withoutZero(Double.toString(value));
    }

    private static String withoutZero(String text) {
        return text.endsWith(".0") ? text.substring(0, text.length() - 2) : text;
    }
}
