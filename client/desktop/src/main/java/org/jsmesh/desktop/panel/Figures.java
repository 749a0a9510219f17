package org.jsmesh.desktop.panel;

import java.util.Locale;
import java.util.StringJoiner;
import org.jsmesh.session.SessionProgress;

/** The numbers of a session in words. */
public final class Figures {
    private Figures() {}

    /**
     * One line of all of them, for example {@code 12,345 of 69,451 faces · 210 kB of 540 kB · 1.2 MB/s · level 3 of 8 ·
     * error 0.021%}.
     *
     * @param p how far the session is
     * @param levels of the model, 0 when it is not known
     * @return the line, without the parts that are not known yet
     */
    public static String line(SessionProgress p, int levels) {
        StringJoiner parts = new StringJoiner("  ·  ");
        if (p.totalFaces() >= 0) parts.add(count(p.faces()) + " of " + count(p.totalFaces()) + " faces");
        parts.add(p.totalBytes() < 0 ? bytes(p.bytes()) : bytes(p.bytes()) + " of " + bytes(p.totalBytes()));
        if (p.bytesPerSecond() > 0) parts.add(bytes(Math.round(p.bytesPerSecond())) + "/s");
        if (levels > 0) parts.add(p.level() == 0 ? "base mesh" : "level " + p.level() + " of " + levels);
        if (p.totalFaces() >= 0 && p.faces() > 0) parts.add("error " + percent(p.errorMean()));
        return parts.toString();
    }

    /**
     * A number with commas.
     *
     * @param n the number
     * @return its digits in groups of three
     */
    public static String count(long n) {
        return String.format(Locale.ENGLISH, "%,d", n);
    }

    /**
     * Bytes in decimal units, as throughput is given in them.
     *
     * @param n their number
     * @return two digits or more, and the unit
     */
    public static String bytes(long n) {
        if (n < 1000) return n + " B";
        if (n < 999_500) return significant(n / 1e3) + " kB";
        if (n < 999_500_000) return significant(n / 1e6) + " MB";
        return significant(n / 1e9) + " GB";
    }

    /**
     * A share with two significant digits.
     *
     * @param percent the share in per cent; 0 means exactly 0
     * @return it in words
     */
    public static String percent(double percent) {
        if (percent == 0) return "0%";
        if (percent < .0001) return "< 0.0001%";
        int digits = Math.max(0, Math.min(4, 1 - (int) Math.floor(Math.log10(percent))));
        return String.format(Locale.ENGLISH, "%." + digits + "f%%", percent);
    }

    private static String significant(double value) {
        return String.format(Locale.ENGLISH, value < 9.95 ? "%.1f" : "%.0f", value);
    }
}
