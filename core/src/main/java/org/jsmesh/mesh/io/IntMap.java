package org.jsmesh.mesh.io;

import java.util.Arrays;
import org.jsmesh.mesh.KeyHash;

/** From int keys to ids ≥ 0; open addressing. */
final class IntMap {
    private static final KeyHash HASH = KeyHash.OF_THIS_RUN;

    private int[] keys = new int[64];
    private int[] ids = new int[64];
    private int size;

    IntMap() {
        Arrays.fill(ids, -1);
    }

    /** The id of a key, or −1. */
    int get(int key) {
        return ids[slot(key)];
    }

    /** Returns false when the key was there already; its id then stays. */
    boolean put(int key, int id) {
        int slot = slot(key);
        if (ids[slot] >= 0) return false;
        keys[slot] = key;
        ids[slot] = id;
        if (2 * ++size > keys.length) grow();
        return true;
    }

    private int slot(int key) {
        int mask = keys.length - 1;
        int slot = HASH.of(key, 0) & mask;
        while (ids[slot] >= 0 && keys[slot] != key) slot = (slot + 1) & mask;
        return slot;
    }

    private void grow() {
        int[] oldKeys = keys;
        int[] oldIds = ids;
        keys = new int[2 * oldKeys.length];
        ids = new int[keys.length];
        Arrays.fill(ids, -1);
        for (int i = 0; i < oldKeys.length; i++) {
            if (oldIds[i] < 0) continue;
            int slot = slot(oldKeys[i]);
            keys[slot] = oldKeys[i];
            ids[slot] = oldIds[i];
        }
    }
}
