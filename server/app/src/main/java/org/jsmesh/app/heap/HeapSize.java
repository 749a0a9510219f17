package org.jsmesh.app.heap;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.TypeConversionException;

/**
 * A size of the heap on the command line, as Java's {@code -Xmx} takes it: {@code 6g}, {@code 1500m}.
 *
 * @param bytes at least 16 MiB
 */
public record HeapSize(long bytes) {
    private static final Pattern SYNTAX = Pattern.compile("(\\d{1,12})([kmgt]?)");
    private static final String UNITS = "kmgt";
    private static final long LEAST = 16 << 20;

    /** Reads a size. */
    public static HeapSize parse(String text) {
        Matcher m = SYNTAX.matcher(text.strip().toLowerCase(Locale.ROOT));
        if (!m.matches()) throw new TypeConversionException("'" + text + "' is no size of a heap such as 6g or 1500m");
        long bytes = Long.parseLong(m.group(1));
        int unit = m.group(2).isEmpty() ? 0 : UNITS.indexOf(m.group(2)) + 1;
        if (bytes > Long.MAX_VALUE >> 10 * unit)
            throw new TypeConversionException("'" + text + "' is more than any machine has");
        bytes <<= 10 * unit;
        if (bytes < LEAST) throw new TypeConversionException("'" + text + "' is less than 16m");
        return new HeapSize(bytes);
    }

    /** {@return the option of Java that sets it, in whole MiB} */
    public String option() {
        return "-Xmx" + (bytes >> 20) + "m";
    }
}
