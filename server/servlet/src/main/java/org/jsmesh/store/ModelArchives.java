package org.jsmesh.store;

import java.io.IOException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;
import org.jsmesh.sandbox.ModelEncoder;
import org.jsmesh.store.cache.ArchiveCache;

/** The archives of models: encoded or opened on first demand, and what is known of them since. Thread-safe. */
final class ModelArchives implements AutoCloseable {
    private final ConcurrentHashMap<String, Preparation> preparations = new ConcurrentHashMap<>();
    private final OpenArchives open;
    private final Wishes wishes;
    private final long wishMillis;
    private final Preparer preparer;
    private final StateCounts counts = new StateCounts();

    /** @throws IOException when archives cannot be kept in the cache folder */
    ModelArchives(StoreSettings settings, ModelEncoder encoder, HeaderReader reader) throws IOException {
        open = new OpenArchives(settings.mostOpen());
        wishes = new Wishes(settings.mostWaiting(), settings.mostWaitingOfClient());
        wishMillis = settings.wishMillis();
        // The default folder is only made when there is no other.
        Path cache = settings.cache() == null ? ArchiveCache.defaultFolder() : settings.cache();
        preparer =
                new Preparer(settings, encoder, reader, ArchiveCache.open(cache, settings.cacheBytes(), open::letGo));
    }

    /**
     * See {@link ModelStore#archive(ModelEntry, String)}.
     *
     * @param client who asks; null for a wish that lasts
     */
    CompletableFuture<Archive> archive(ModelEntry entry, String client) throws ModelUnavailableException {
        Preparation known = preparations.get(entry.id());
        SourceStamp stamp;
        try {
            stamp = SourceStamp.of(entry.path(), known == null ? Set.of() : known.witnesses());
        } catch (NoSuchFileException e) {
            throw ModelUnavailableException.gone(entry.id(), e);
        } catch (IOException e) {
            throw ModelUnavailableException.ofModel(
                    "the file of model '" + entry.id() + "' cannot be read", "ask the server's owner", e);
        }
        if (known == null || !known.isGoodFor(entry, stamp)) known = begin(entry, stamp, client);
        known.wish().renew(client);
        if (known.seen().open() != null) open.use(known);
        return known.archive();
    }

    private synchronized Preparation begin(ModelEntry entry, SourceStamp stamp, String client)
            throws ModelUnavailableException {
        Preparation known = preparations.get(entry.id());
        if (known != null && known.isGoodFor(entry, stamp)) return known;
        if (wishes.isFull()) dropForgotten();
        Preparation next = new Preparation(entry, stamp, new Wish(client, wishMillis), known);
        wishes.begin(next.wish());
        next.countIn(counts.begin(entry.id()));
        if (known != null) forget(known);
        preparations.put(entry.id(), next);
        next.archive().whenComplete((archive, failure) -> {
            wishes.end(next.wish());
            if (archive != null) open.use(next);
            // Nobody is to hear of a failure because others went away.
            else if (next.wish().isGone() && preparations.remove(entry.id(), next))
                next.counted().end();
        });
        preparer.start(next);
        return next;
    }

    /** Takes those off the queue that nobody asks for any more. */
    private void dropForgotten() {
        preparations.values().forEach(preparation -> {
            if (preparation.wish().isGone()) preparer.drop(preparation);
        });
    }

    private void forget(Preparation preparation) {
        open.remove(preparation);
        preparation.dispose();
        preparation.counted().end();
    }

    /** See {@link ModelStore#recent}. */
    Archive recent(ModelEntry entry) {
        Preparation known = preparations.get(entry.id());
        return known == null || !known.isRecent(entry) ? null : known.open();
    }

    /** The state of a model, as far as it is known without a look at its file. */
    ModelStatus status(ModelEntry entry) {
        Preparation known = preparations.get(entry.id());
        if (known == null || !known.isListed(entry))
            return new ModelStatus(entry, ModelStatus.State.NEW, null, null, 0, null);
        ArchiveFacts facts = known.facts();
        if (facts != null) return new ModelStatus(entry, ModelStatus.State.READY, facts, null, 1, null);
        CompletableFuture<Archive> result = known.archive();
        if (!result.isCompletedExceptionally())
            return new ModelStatus(entry, ModelStatus.State.PREPARING, null, known.stage(), known.fraction(), null);
        try {
            result.join();
            throw new IllegalStateException("a failure without a reason");
        } catch (CompletionException e) {
            ModelUnavailableException failure = (ModelUnavailableException) e.getCause();
            return new ModelStatus(entry, ModelStatus.State.FAILED, null, null, 0, failure);
        }
    }

    /** See {@link ModelStore#isOpening}. */
    boolean isOpening(ModelEntry entry) {
        Preparation known = preparations.get(entry.id());
        return known != null && known.stage().equals(Preparation.OPENING);
    }

    /** Forgets models that are gone, and gives up their encodings. */
    void keepOnly(Predicate<String> isThere) {
        preparations.forEach((id, preparation) -> {
            if (!isThere.test(id) && preparations.remove(id, preparation)) forget(preparation);
        });
    }

    /** How many models are in each state. */
    StateCounts counts() {
        return counts;
    }

    Preparer preparer() {
        return preparer;
    }

    /** Gives up running encodings. Archives that are being sent stay readable. */
    @Override
    public void close() {
        // In this order, so that a cancelled request knows why.
        preparer.stop();
        preparations.values().forEach(this::forget);
        preparer.close();
    }
}
