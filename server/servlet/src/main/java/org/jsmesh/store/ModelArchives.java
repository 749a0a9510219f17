package org.jsmesh.store;

import java.io.IOException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;

/** The archives of models: encoded or opened on first demand, and what is known of them since. Thread-safe. */
final class ModelArchives implements AutoCloseable {
    private final Preparer preparer;
    private final ConcurrentHashMap<String, Preparation> preparations = new ConcurrentHashMap<>();

    ModelArchives(Preparer preparer) {
        this.preparer = preparer;
    }

    /** See {@link ModelStore#archive}. */
    CompletableFuture<Archive> archive(ModelEntry entry) throws ModelUnavailableException {
        SourceStamp stamp;
        try {
            stamp = SourceStamp.of(entry.path());
        } catch (IOException e) {
            throw new ModelUnavailableException(
                    "the file of model '" + entry.id() + "' cannot be read any more", "ask for the catalogue again", e);
        }
        return preparations
                .compute(entry.id(), (id, known) -> {
                    if (known != null && known.isGoodFor(entry, stamp)) return known.seen();
                    if (known != null) known.cancel();
                    return preparer.start(new Preparation(entry, stamp));
                })
                .archive();
    }

    /** See {@link ModelStore#recent}. */
    Archive recent(ModelEntry entry) {
        Preparation known = preparations.get(entry.id());
        if (known == null || !known.isRecent(entry)) return null;
        return known.archive().isCompletedExceptionally()
                ? null
                : known.archive().getNow(null);
    }

    /** The state of a model. */
    ModelStatus status(ModelEntry entry) {
        Preparation preparation = preparations.get(entry.id());
        if (preparation == null || !isCurrent(preparation, entry)) {
            return new ModelStatus(entry, ModelStatus.State.NEW, null, null, 0, null);
        }
        if (!preparation.archive().isDone()) {
            String stage = preparation.stage();
            return new ModelStatus(entry, ModelStatus.State.PREPARING, null, stage, preparation.fraction(), null);
        }
        try {
            ArchiveFacts facts = ArchiveFacts.of(preparation.archive().join());
            return new ModelStatus(entry, ModelStatus.State.READY, facts, null, 1, null);
        } catch (CompletionException e) {
            ModelUnavailableException failure = (ModelUnavailableException) e.getCause();
            return new ModelStatus(entry, ModelStatus.State.FAILED, null, null, 0, failure);
        }
    }

    private static boolean isCurrent(Preparation preparation, ModelEntry entry) {
        try {
            return preparation.isGoodFor(entry, SourceStamp.of(entry.path()));
        } catch (IOException e) {
            return false;
        }
    }

    /** Forgets models that are gone, and gives up their encodings. */
    void keepOnly(Predicate<String> isThere) {
        preparations.forEach((id, preparation) -> {
            if (!isThere.test(id) && preparations.remove(id, preparation)) preparation.cancel();
        });
    }

    Preparer preparer() {
        return preparer;
    }

    /** Gives up running encodings. Archives that are being sent stay readable. */
    @Override
    public void close() {
        // In this order, so that a cancelled request knows why.
        preparer.close();
        preparations.values().forEach(Preparation::cancel);
    }
}
