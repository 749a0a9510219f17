package org.jsmesh.app;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.TypeConversionException;

/**
 * A waiting time of the command line: {@code 2s}, {@code 500ms}, {@code 1.5} (seconds).
 *
 * @param millis at least 1
 */
record Wait(int millis) {
    private static final Pattern SYNTAX = Pattern.compile("(\\d{1,6}(?:\\.\\d{1,6})?)(ms|s|)");

    static Wait parse(String text) {
        Matcher m = SYNTAX.matcher(text.strip());
        if (!m.matches()) throw new TypeConversionException("'" + text + "' is no time such as 2s or 500ms");
        double millis = Double.parseDouble(m.group(1)) * (m.group(2).equals("ms") ? 1 : 1000);
        if (millis < 1) throw new TypeConversionException("'" + text + "' is shorter than 1ms");
        return new Wait((int) Math.min(Math.round(millis), Integer.MAX_VALUE));
    }
}
