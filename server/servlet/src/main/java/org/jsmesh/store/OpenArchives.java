package org.jsmesh.store;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The models whose archives are open: those that were used last. Each takes a file descriptor, and memory for its
 * header and checksums. Thread-safe.
 */
final class OpenArchives {
    private final int most;
    private final Map<Preparation, Boolean> byUse = new LinkedHashMap<>(16, 0.75f, true);

    /** @param most archives that are open, besides those that are being sent */
    OpenArchives(int most) {
        this.most = most;
    }

    /** A model is used whose archive is open; closes that of another one if there are too many. */
    synchronized void use(Preparation preparation) {
        byUse.put(preparation, true);
        Iterator<Preparation> eldest = byUse.keySet().iterator();
        while (byUse.size() > most && eldest.hasNext()) {
            Preparation candidate = eldest.next();
            Archive archive = candidate.open();
            if (archive != null && archive.isInUse()) continue;
            eldest.remove();
            candidate.rest();
        }
    }

    synchronized void remove(Preparation preparation) {
        byUse.remove(preparation);
    }

    /** Closes every archive with that hash, unless somebody reads one; returns false then. */
    synchronized boolean letGo(String sha256) {
        List<Preparation> holding = new ArrayList<>();
        for (Preparation preparation : byUse.keySet()) {
            Archive archive = preparation.open();
            if (archive == null || !archive.sha256().equals(sha256)) continue;
            if (archive.isInUse()) return false;
            holding.add(preparation);
        }
        for (Preparation preparation : holding) {
            byUse.remove(preparation);
            preparation.rest();
        }
        return true;
    }
}
