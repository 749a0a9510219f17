package org.jsmesh.store;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;

/**
 * The models in order of their ids, in pieces that stay as they are while models of other pieces come and go: each has
 * at most 1000, and two neighbours have more than that together. A change gives its piece another version. Thread-safe.
 */
final class Listing {
    private static final int MOST = ModelPage.MOST;

    private final List<Piece> pieces = new ArrayList<>();
    private final Function<ModelEntry, ModelStatus> status;
    private long version;
    private long shape;
    private int size;

    private static final class Piece {
        final List<ModelEntry> models;
        long version;

        Piece(List<ModelEntry> models) {
            this.models = models;
        }

        String first() {
            return models.get(0).id();
        }

        String last() {
            return models.get(models.size() - 1).id();
        }

        /** Place of the first model whose id is not less. */
        int place(String id) {
            int from = 0;
            int to = models.size();
            while (from < to) {
                int middle = (from + to) >>> 1;
                if (models.get(middle).id().compareTo(id) < 0) from = middle + 1;
                else to = middle;
            }
            return from;
        }
    }

    /** @param status tells the state of a model when a page is read */
    Listing(Function<ModelEntry, ModelStatus> status) {
        this.status = status;
    }

    /** @param entry null when no model has the id any more */
    synchronized void changed(String id, ModelEntry entry) {
        if (pieces.isEmpty()) {
            if (entry == null) return;
            pieces.add(new Piece(new ArrayList<>()));
        }
        int at = pieceOf(id);
        Piece piece = pieces.get(at);
        int place = piece.place(id);
        boolean isThere =
                place < piece.models.size() && piece.models.get(place).id().equals(id);
        if (entry == null && !isThere) return;
        if (entry == null) {
            piece.models.remove(place);
            size--;
        } else if (isThere) {
            piece.models.set(place, entry);
        } else {
            insert(at, place, entry);
            size++;
        }
        piece.version = ++version;
        if (!isThere || entry == null) shape++;
        if (piece.models.isEmpty()) pieces.remove(at);
        else if (!isThere || entry == null) balance(at);
    }

    /** The state of a model has changed. */
    synchronized void touched(String id) {
        if (!pieces.isEmpty()) pieces.get(pieceOf(id)).version = ++version;
    }

    private void insert(int at, int place, ModelEntry entry) {
        List<ModelEntry> models = pieces.get(at).models;
        boolean isEnd = at == pieces.size() - 1 && place == models.size();
        if (models.size() == MOST && isEnd) {
            // Models that come in order fill their pieces.
            pieces.add(piece(List.of(entry)));
            return;
        }
        models.add(place, entry);
        if (models.size() <= MOST) return;
        List<ModelEntry> rest = models.subList(MOST / 2, models.size());
        pieces.add(at + 1, piece(rest));
        rest.clear();
    }

    private Piece piece(List<ModelEntry> models) {
        Piece piece = new Piece(new ArrayList<>(models));
        piece.version = ++version;
        return piece;
    }

    /** Joins neighbours that have become small. */
    private void balance(int changed) {
        for (int at = Math.min(changed + 1, pieces.size() - 2); at >= Math.max(0, changed - 1); at--) {
            Piece piece = pieces.get(at);
            List<ModelEntry> next = pieces.get(at + 1).models;
            if (piece.models.size() + next.size() > MOST) continue;
            piece.models.addAll(next);
            piece.version = ++version;
            pieces.remove(at + 1);
        }
    }

    /** The piece that has the id or is the place for it. */
    private int pieceOf(String id) {
        int from = 0;
        int to = pieces.size() - 1;
        while (from < to) {
            int middle = (from + to + 1) >>> 1;
            if (pieces.get(middle).first().compareTo(id) <= 0) from = middle;
            else to = middle - 1;
        }
        return from;
    }

    /** The models behind an id, up to the end of a piece; the first ones for null. */
    synchronized ModelPage page(String after) {
        if (pieces.isEmpty()) return new ModelPage(after, null, 0, version, after == null, List::of, shape, List::of);
        int at = after == null ? 0 : pieceOf(after);
        if (after != null && pieces.get(at).last().compareTo(after) <= 0) at++;
        if (at == pieces.size()) return new ModelPage(after, null, size, version, false, List::of, shape, List::of);
        Piece piece = pieces.get(at);
        String next = at + 1 < pieces.size() ? piece.last() : null;
        boolean isWhole = after == null || piece.first().compareTo(after) > 0;
        String from = isWhole ? piece.first() : after;
        return new ModelPage(
                after, next, size, piece.version, isWhole, () -> statuses(piece, from, isWhole), shape, this::parts);
    }

    private synchronized List<ModelPage.Part> parts() {
        List<ModelPage.Part> parts = new ArrayList<>(pieces.size());
        String after = null;
        for (Piece piece : pieces) {
            parts.add(new ModelPage.Part(piece.first(), piece.models.size(), after));
            after = piece.last();
        }
        return parts;
    }

    private List<ModelStatus> statuses(Piece piece, String from, boolean isWhole) {
        return copy(piece, from, isWhole).stream().map(status).toList();
    }

    private synchronized List<ModelEntry> copy(Piece piece, String from, boolean isWhole) {
        List<ModelEntry> models = piece.models;
        if (isWhole) return List.copyOf(models);
        int place = piece.place(from);
        boolean isThere = place < models.size() && models.get(place).id().equals(from);
        return List.copyOf(models.subList(isThere ? place + 1 : place, models.size()));
    }

    /** All models. */
    synchronized List<ModelEntry> all() {
        List<ModelEntry> all = new ArrayList<>(size);
        for (Piece piece : pieces) all.addAll(piece.models);
        return all;
    }

    synchronized int size() {
        return size;
    }
}
