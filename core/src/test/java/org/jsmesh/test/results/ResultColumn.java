package org.jsmesh.test.results;

/**
 * A figure that a table of results has for each row.
 *
 * @param name at the head of its column
 * @param rule when it is worse than it was
 * @param least values up to this count as equal: of a flat model's error nothing but noise is left
 */
public record ResultColumn(String name, Rule rule, double least) {
    /** When a figure is worse. */
    public enum Rule {
        /** Never: others are measured by it, and it stays as it was recorded. */
        GIVEN,
        /** When it is larger by more than a share. */
        SMALL,
        /** When it is another one. */
        SAME
    }

    public static ResultColumn given(String name) {
        return new ResultColumn(name, Rule.GIVEN, 0);
    }

    public static ResultColumn small(String name) {
        return small(name, 0);
    }

    public static ResultColumn small(String name, double least) {
        return new ResultColumn(name, Rule.SMALL, least);
    }

    public static ResultColumn same(String name) {
        return new ResultColumn(name, Rule.SAME, 0);
    }

    /** What a figure is in parts of what it was; above 1 it is worse. */
    double change(double before, double now) {
        return Math.max(now, least) / Math.max(before, least);
    }

    boolean isWorse(double before, double now, double tolerated) {
        return switch (rule) {
            case GIVEN -> false;
            case SMALL -> Math.max(now, least) > Math.max(before, least) * (1 + tolerated);
            case SAME -> now != before;
        };
    }
}
