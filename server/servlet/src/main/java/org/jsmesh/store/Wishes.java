package org.jsmesh.store;

import java.util.HashMap;
import java.util.Map;

/** Counts the models that are being prepared, in all and for each client that asked first. Thread-safe. */
final class Wishes {
    private final int most;
    private final int mostOfClient;
    private final Map<String, Integer> byClient = new HashMap<>();
    private int all;

    Wishes(int most, int mostOfClient) {
        this.most = most;
        this.mostOfClient = mostOfClient;
    }

    /** @throws ModelUnavailableException when there are too many */
    synchronized void begin(Wish wish) throws ModelUnavailableException {
        if (all >= most)
            throw ModelUnavailableException.passing("too many models wait to be encoded", "ask again later", null);
        if (wish.client() != null) {
            int own = byClient.getOrDefault(wish.client(), 0);
            if (own >= mostOfClient)
                throw ModelUnavailableException.passing(
                        own + " models that you asked for wait to be encoded", "ask again when some are ready", null);
            byClient.put(wish.client(), own + 1);
        }
        all++;
    }

    synchronized void end(Wish wish) {
        all--;
        if (wish.client() != null) byClient.computeIfPresent(wish.client(), (c, own) -> own == 1 ? null : own - 1);
    }

    synchronized boolean isFull() {
        return all >= most;
    }
}
