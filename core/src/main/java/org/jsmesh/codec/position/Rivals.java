package org.jsmesh.codec.position;

/**
 * Chooses among three predictions the one that was best for the last vertices of as many neighbours, and for the last
 * of all. Errors are running means.
 */
final class Rivals {
    private static final int GROUPS = 5; // by number of neighbours: up to 4, 5, 6, 7, more
    private static final int ALL = 3 * GROUPS;

    /** Part of one vertex in a running mean. */
    static final double PART = 1.0 / 64;

    private static final double MOST_ERROR = 12;
    private static final double CLOSE = 1.03;
    private final double[] errors = new double[ALL + 3];
    private int at;

    /** The error of a prediction that is so many units off; more of them count no more. */
    static double error(double units) {
        return Math.min(MOST_ERROR, Math.abs(units));
    }

    /** Turns to a vertex of so many neighbours. */
    void turn(int neighbours) {
        at = 3 * Math.max(0, Math.min(GROUPS - 1, neighbours - 4));
    }

    /** The best one, of several the first: 0, 1 or 2. The arguments are errors that this vertex is known to have. */
    int best(double first, double second, double third) {
        double a = first + errors[at] + errors[ALL];
        double b = second + errors[at + 1] + errors[ALL + 1];
        double c = third + errors[at + 2] + errors[ALL + 2];
        if (a <= b) return a <= c ? 0 : 2;
        return b <= c ? 1 : 2;
    }

    /** Was the third one nearly as good as the others, or better? */
    boolean isThirdClose() {
        double a = errors[at] + errors[ALL];
        double b = errors[at + 1] + errors[ALL + 1];
        return errors[at + 2] + errors[ALL + 2] < CLOSE * Math.min(a, b);
    }

    /** Learns an error of the first, second or third one: 0, 1 or 2. */
    void learn(int which, double error) {
        errors[at + which] += (error - errors[at + which]) * PART;
        errors[ALL + which] += (error - errors[ALL + which]) * PART;
    }
}
