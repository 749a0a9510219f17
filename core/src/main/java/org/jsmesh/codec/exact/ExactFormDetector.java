package org.jsmesh.codec.exact;

/** Finds the form of a table of numbers: how many decimals they have, if they are decimals. */
final class ExactFormDetector {
    /** Numbers by which the decimals are chosen. */
    private static final int SAMPLE = 1 << 12;

    /** The share of numbers that may be no decimals. */
    private static final double TOLERATED = .05;

    private final double[] numbers;
    private final int components;
    private final double[] given; // origins, or null

    /**
     * @param numbers components × rows; NaN where there is none
     * @param given origins to count from, rounded; null to choose them
     */
    private ExactFormDetector(double[] numbers, int components, double[] given) {
        this.numbers = numbers;
        this.components = components;
        this.given = given;
    }

    static ExactForm detect(double[] numbers, int components, double[] given) {
        ExactFormDetector detector = new ExactFormDetector(numbers, components, given);
        for (int places = 0; places <= ExactForm.MOST_PLACES; places++) {
            ExactForm form = detector.decimals(places);
            if (form != null) return form;
        }
        return detector.binary();
    }

    private ExactForm decimals(int places) {
        double scale = ExactForm.power(places);
        int step = Math.max(1, numbers.length / SAMPLE);
        while (step % 2 == 0 || step % 3 == 0) step++; // to meet all components
        if (exceptions(scale, step) > TOLERATED * numbers.length / step) return null;
        int exceptions = exceptions(scale, 1);
        if (exceptions > TOLERATED * numbers.length) return null;
        double[] low = new double[components];
        double[] high = new double[components];
        if (!findBounds(scale, low, high)) return null;
        double[] origins = new double[components];
        for (int c = 0; c < components; c++) {
            if (given != null) origins[c] = Math.floor(given[c] * scale + .5);
            else if (Math.max(Math.abs(low[c]), Math.abs(high[c])) > 2 * (high[c] - low[c])) origins[c] = low[c];
            if (Math.abs(origins[c]) >= 1L << 53) return null;
            if (high[c] - origins[c] >= ExactForm.MOST_UNITS || origins[c] - low[c] >= ExactForm.MOST_UNITS)
                return null;
        }
        ExactForm form = new ExactForm(places, origins, true, 0, false);
        boolean whole = true;
        int zeros = 52;
        exceptions = 0;
        for (int i = 0; i < numbers.length; i++) {
            double x = numbers[i];
            if (x != x) continue;
            double units = form.units(i % components, x);
            if (units != units) {
                exceptions++;
                zeros = Math.min(zeros, zeros(x));
            } else if (whole) {
                whole = form.spread(form.offset(i % components, x)) == 0;
            }
        }
        boolean hasExceptions = exceptions > 0;
        return new ExactForm(places, origins, hasExceptions, hasExceptions ? zeros : 0, whole && !hasExceptions);
    }

    /** Numbers that are no such decimals, among every so many. */
    private int exceptions(double scale, int step) {
        int exceptions = 0;
        for (int i = 0; i < numbers.length; i += step) {
            double units = ExactForm.units(numbers[i], scale, 0);
            if (units != units && numbers[i] == numbers[i]) exceptions++;
        }
        return exceptions;
    }

    /** False when there is no decimal. */
    private boolean findBounds(double scale, double[] low, double[] high) {
        boolean[] any = new boolean[components];
        boolean found = false;
        for (int i = 0; i < numbers.length; i++) {
            double units = ExactForm.units(numbers[i], scale, 0);
            if (units != units) continue;
            int c = i % components;
            if (!any[c] || units < low[c]) low[c] = units;
            if (!any[c] || units > high[c]) high[c] = units;
            any[c] = true;
            found = true;
        }
        return found;
    }

    private ExactForm binary() {
        double[] origins = new double[components];
        int zeros = 52;
        for (double x : numbers) if (x == x) zeros = Math.min(zeros, zeros(x));
        for (int c = 0; c < components; c++) {
            if (given == null) origins[c] = first(c);
            else origins[c] = given[c];
        }
        return new ExactForm(ExactForm.BINARY, origins, false, zeros, false);
    }

    /** An origin for a component whose numbers lie all on one side of 0 and far from it; else 0. */
    private double first(int component) {
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int i = component; i < numbers.length; i += components) {
            if (numbers[i] != numbers[i]) continue;
            low = Math.min(low, numbers[i]);
            high = Math.max(high, numbers[i]);
        }
        return low <= high && Math.max(Math.abs(low), Math.abs(high)) > 2 * (high - low) ? low : 0;
    }

    private static int zeros(double x) {
        return Math.min(52, Long.numberOfTrailingZeros(Double.doubleToRawLongBits(x)));
    }
}
