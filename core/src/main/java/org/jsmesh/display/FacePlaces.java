package org.jsmesh.display;

import java.util.Arrays;

/**
 * Where faces lie in an array of indices, by display slot. A face keeps its place. The faces of a slot lie in runs; a
 * run that is full grows while nothing lies behind it, else the slot begins another one, half as large as what it has.
 */
final class FacePlaces {
    private static final int LEAST_RUN = 64;
    private static final int NONE = -1;

    private int[] places = new int[0]; // of each face, or −1
    private final int[] firstRun; // of each slot, or −1
    private final int[] lastRun;
    private final int[] sizes; // faces of each slot
    private int[] runs = new int[4 * 64]; // first place, faces, room, next run of the slot or −1
    private int runCount;
    private int end; // of the last run's room

    FacePlaces(int slots) {
        firstRun = new int[slots];
        lastRun = new int[slots];
        sizes = new int[slots];
        Arrays.fill(firstRun, NONE);
        Arrays.fill(lastRun, NONE);
    }

    /** Makes room for faces with numbers below a number. */
    void reserve(int numbers) {
        int before = places.length;
        if (numbers <= before) return;
        places = Arrays.copyOf(places, numbers + numbers / 2);
        Arrays.fill(places, before, places.length, NONE);
    }

    /** Finds the place of a face, and gives one to a new face. */
    int place(int face, int slot) {
        if (places[face] == NONE) places[face] = newPlace(slot);
        return places[face];
    }

    /** The place of a face; negative where it has none. */
    int of(int face) {
        return face < places.length ? places[face] : NONE;
    }

    private int newPlace(int slot) {
        int run = lastRun[slot];
        if (run == NONE || runs[4 * run + 1] == runs[4 * run + 2]) run = roomyRun(slot, run);
        sizes[slot]++;
        return runs[4 * run] + runs[4 * run + 1]++;
    }

    private int roomyRun(int slot, int full) {
        boolean isAlone = sizes.length == 1;
        int more = isAlone ? 1 : Math.max(LEAST_RUN, sizes[slot] / 2);
        if (full != NONE && runs[4 * full] + runs[4 * full + 2] == end) {
            runs[4 * full + 2] += more;
            end += more;
            return full;
        }
        if (4 * runCount == runs.length) runs = Arrays.copyOf(runs, 2 * runs.length);
        runs[4 * runCount] = end;
        runs[4 * runCount + 1] = 0;
        runs[4 * runCount + 2] = more;
        runs[4 * runCount + 3] = NONE;
        if (full == NONE) firstRun[slot] = runCount;
        else runs[4 * full + 3] = runCount;
        lastRun[slot] = runCount;
        end += more;
        return runCount++;
    }

    /** Places in all runs. */
    int end() {
        return end;
    }

    /** The groups of {@link LiveMesh#groups}. */
    int[] groups() {
        int[] groups = new int[3 * runCount];
        int n = 0;
        for (int slot = 0; slot < firstRun.length; slot++) {
            for (int run = firstRun[slot]; run != NONE; run = runs[4 * run + 3]) {
                groups[n++] = slot;
                groups[n++] = 3 * runs[4 * run];
                groups[n++] = 3 * runs[4 * run + 1];
            }
        }
        return groups;
    }
}
