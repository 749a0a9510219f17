package org.jsmesh.desktop;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads {@code 2s}, {@code 1.5s}, {@code 500ms}, or seconds without a unit, as milliseconds. */
final class WaitConverter implements ITypeConverter<Integer> {
    private static final int MOST_MILLIS = 3_600_000;

    @Override
    public Integer convert(String text) {
        Matcher m = Pattern.compile("(\\d{1,7}(?:\\.\\d{1,6})?)(ms|s|)").matcher(text);
        if (!m.matches()) throw new TypeConversionException("'" + text + "' is no time; write for example 2s or 500ms");
        BigDecimal number = new BigDecimal(m.group(1));
        if (!m.group(2).equals("ms")) number = number.movePointRight(3);
        int millis = number.setScale(0, RoundingMode.HALF_UP)
                .min(BigDecimal.valueOf(Integer.MAX_VALUE))
                .intValueExact();
        if (millis < 1 || millis > MOST_MILLIS) {
            throw new TypeConversionException("'" + text + "' is not between 1ms and an hour");
        }
        return millis;
    }

    /** The other way round, for people. */
    static String words(int millis) {
        return millis % 1000 == 0 ? millis / 1000 + " s" : millis + " ms";
    }
}
