package org.jsmesh.desktop;

import java.util.Locale;
import java.util.StringJoiner;
import org.jsmesh.session.SessionProgress;

/** The numbers of a session in words, for the status line. */
final class Figures {
    private Figures() {}

    /**
     * For example {@code 12,345 of 69,451 faces · 210 kB of 540 kB · 1.2 MB/s · level 3 of 8 · error 0.021%}; parts not
     * known yet are left out.
     */
    static String line(SessionProgress p, int levels) {
        StringJoiner parts = new StringJoiner("  ·  ");
        if (p.totalFaces() >= 0) parts.add(count(p.faces()) + " of " + count(p.totalFaces()) + " faces");
        parts.add(p.totalBytes() < 0 ? bytes(p.bytes()) : bytes(p.bytes()) + " of " + bytes(p.totalBytes()));
        if (p.bytesPerSecond() > 0) parts.add(bytes(Math.round(p.bytesPerSecond())) + "/s");
        if (levels > 0) parts.add(p.level() == 0 ? "base mesh" : "level " + p.level() + " of " + levels);
        if (p.totalFaces() >= 0 && p.faces() > 0) parts.add("error " + percent(p.errorMean()));
        return parts.toString();
    }

    static String count(long n) {
        return String.format(Locale.ENGLISH, "%,d", n);
    }

    /** Decimal units, as throughput is given in them. */
    static String bytes(long n) {
        if (n < 1000) return n + " B";
        if (n < 999_500) return significant(n / 1e3) + " kB";
        if (n < 999_500_000) return significant(n / 1e6) + " MB";
        return significant(n / 1e9) + " GB";
    }

    /** A share in per cent, with two significant digits; 0 means exactly 0. */
    static String percent(double percent) {
        if (percent == 0) return "0%";
        if (percent < .0001) return "< 0.0001%";
        int digits = Math.max(0, Math.min(4, 1 - (int) Math.floor(Math.log10(percent))));
        return String.format(Locale.ENGLISH, "%." + digits + "f%%", percent);
    }

    private static String significant(double value) {
        return String.format(Locale.ENGLISH, value < 9.95 ? "%.1f" : "%.0f", value);
    }
}
