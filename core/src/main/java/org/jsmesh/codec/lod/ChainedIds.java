package org.jsmesh.codec.lod;

import java.util.Arrays;

/** Ids in short lists, one list per key, in the order in which they were added. */
public final class ChainedIds {
    private final int[] first;
    private final int[] last;
    private final int[] next;

    public ChainedIds(int keys, int ids) {
        first = new int[keys];
        last = new int[keys];
        next = new int[ids];
        Arrays.fill(first, -1);
        Arrays.fill(next, -1);
    }

    public void add(int key, int id) {
        if (first[key] < 0) first[key] = id;
        else next[last[key]] = id;
        last[key] = id;
    }

    /** The first id of a key, or −1. */
    public int first(int key) {
        return first[key];
    }

    /** The id after one, or −1. */
    public int next(int id) {
        return next[id];
    }
}
