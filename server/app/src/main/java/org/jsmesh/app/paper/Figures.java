package org.jsmesh.app.paper;

import java.util.Arrays;
import java.util.Locale;

/** Numbers as the tables have them. */
final class Figures {
    static final String NONE = "–";

    private Figures() {}

    static String count(long number) {
        return String.format(Locale.ROOT, "%,d", number);
    }

    /** With three digits at least. */
    static String number(double x) {
        if (Double.isNaN(x)) return NONE;
        if (x == Math.rint(x)) return String.format(Locale.ROOT, "%,.0f", x);
        int digits = (int) Math.max(0, 2 - Math.floor(Math.log10(Math.abs(x))));
        return String.format(Locale.ROOT, "%,." + digits + "f", x);
    }

    /** What we have over what the paper has. */
    static String ratio(double here, double paper) {
        return number(here / paper);
    }

    static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        int n = sorted.length;
        return n % 2 == 1 ? sorted[n / 2] : (sorted[n / 2 - 1] + sorted[n / 2]) / 2;
    }

    static double millisSince(long nanos) {
        return (System.nanoTime() - nanos) / 1e6;
    }
}
