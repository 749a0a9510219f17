package org.jsmesh.plan;

/**
 * A number as messages have it, without its fraction. The class library's text of a double needs tables that are larger
 * than this package, and the page would have to load them.
 */
final class WholeNumber {
    private WholeNumber() {}

    static String of(double value) {
        return Double.isNaN(value) ? "NaN" : String.valueOf((long) value);
    }
}
