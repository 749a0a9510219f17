package org.jsmesh.spark;

import java.io.Serializable;

/**
 * Files that have one place in the catalogue.
 *
 * @param count how many
 * @param first the least of their addresses
 * @param second the one behind it; empty while there is but one
 */
record SamePlace(long count, String first, String second) implements Serializable {
    private static final long serialVersionUID = 1;

    static SamePlace of(ListedModel file) {
        return new SamePlace(1, file.input(), "");
    }

    /** {@return all of both} */
    SamePlace and(SamePlace other) {
        boolean isFirst = first.compareTo(other.first) <= 0;
        SamePlace a = isFirst ? this : other;
        SamePlace b = isFirst ? other : this;
        boolean isNext = !a.second.isEmpty() && a.second.compareTo(b.first) < 0;
        return new SamePlace(count + other.count, a.first, isNext ? a.second : b.first);
    }

    boolean isTaken() {
        return count > 1;
    }

    /** {@return the words for two files or more} */
    String said(String place) {
        return count == 2
                ? first + " and " + second + " are both " + place
                : first + ", " + second + " and " + (count - 2) + " more are all " + place;
    }
}
