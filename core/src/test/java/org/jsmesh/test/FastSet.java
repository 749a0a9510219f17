package org.jsmesh.test;

/**
 * Whether this run is the fast set, {@code mvn verify -Pfast}: it leaves out tests tagged {@code slow} and those that
 * need more than a JDK, and tests that repeat something many times do so less often. {@code docs/developing.md} says
 * what it leaves out.
 */
public final class FastSet {
    private FastSet() {}

    /** Whether the system property {@code jsm.test.fast} is {@code true}. */
    public static boolean isOn() {
        return Boolean.getBoolean("jsm.test.fast");
    }

    /** The first number in the fast set, the second one otherwise. */
    public static int choose(int fast, int full) {
        return isOn() ? fast : full;
    }
}
