package org.jsmesh.desktop.draw;

import org.jsmesh.display.LiveStep;

/** Goes through the ranges of a step in portions, so that no frame has to wait for all of them. */
final class RangeSlices {
    private final int[] ranges;
    private int range;
    private int applied; // elements of the range
    private int array;
    private int first;
    private int at;
    private int next; // element of the data
    private int count;

    RangeSlices(LiveStep step) {
        ranges = step.ranges();
    }

    /**
     * Moves on to the next slice, which lies in one range.
     *
     * @param most elements that it may have, at least 1
     * @return false at the end
     */
    boolean next(int most) {
        if (isOver()) return false;
        int left = ranges[3 * range + 2] - applied;
        array = ranges[3 * range];
        first = ranges[3 * range + 1] + applied;
        count = Math.min(left, most);
        at = next;
        next += count;
        applied += count;
        if (count == left) {
            range++;
            applied = 0;
        }
        return true;
    }

    boolean isOver() {
        return 3 * range == ranges.length;
    }

    int array() {
        return array;
    }

    /** Its first element in the array. */
    int first() {
        return first;
    }

    /** Its first element in the data of the step. */
    int at() {
        return at;
    }

    int count() {
        return count;
    }
}
