package org.jsmesh.site;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.time.Duration;
import java.time.Instant;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.jsmesh.objects.Condition;
import org.jsmesh.objects.ObjectConflictException;
import org.jsmesh.objects.ObjectContent;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;
import org.jsmesh.objects.Upload;

/**
 * Changes the catalogue of a site, which may have millions of models: reads its one changing object,
 * {@code m/index.json}, and the pages that change, writes these under other names, then that object under the condition
 * that it is still the same. When somebody else has written meanwhile, the changes are made anew upon theirs, so no
 * writer loses those of another. Nothing is listed. Needs memory for a few pages.
 *
 * <p>What is replaced stays for a day, for readers on their way; a later update removes it.
 */
public final class CatalogueWriter {
    private static final int MOST_TRIES = 200;
    private static final int LONGEST_PAUSE_MILLIS = 500;

    private final ObjectStore store;
    private final Random random = new Random();
    private Instant time = Instant.EPOCH;
    private int page = CataloguePages.MOST;
    private int first = CataloguePages.MOST_IN_ROOT;

    /** @param store of the site */
    public CatalogueWriter(ObjectStore store) {
        this.store = store;
    }

    /** Of other sizes, for tests. */
    CatalogueWriter(ObjectStore store, int mostOnPage, int mostInRoot) {
        this(store);
        page = mostOnPage;
        first = mostInRoot;
    }

    /**
     * What an update has done.
     *
     * @param total number of models in the catalogue now
     * @param added number of models that were not in it before
     * @param changed number of models of which it says something else
     * @param removed number of models that it had before
     */
    public record Result(long total, long added, long changed, long removed) {}

    /**
     * Makes changes, then removes what was replaced more than a day ago.
     *
     * @param changes in order of the ids ({@link String#compareTo}), at most one of each id; gone through once for each
     *     try
     * @return what has changed
     * @throws IllegalArgumentException when the changes are in another order
     * @throws IOException when the site cannot be read or written; its catalogue is as it was then, or has all changes
     *     when only the removal failed
     */
    public Result update(Iterable<CatalogueRow> changes) throws IOException {
        return update(changes, Instant.now());
    }

    Result update(Iterable<CatalogueRow> changes, Instant now) throws IOException {
        Set<String> written = new HashSet<>();
        long generation = 0; // of the first try: later ones find the pages that are there already
        for (int i = 0; ; i++) {
            CatalogueRoot before = CatalogueRoot.read(store);
            if (generation == 0) generation = before.generation() + 1;
            Superseded superseded = new Superseded(store, now);
            CataloguePages pages =
                    new CataloguePages(store, before, Math.max(generation, 1), superseded, written, page, first);
            pages.apply(changes);
            CatalogueRoot after = pages.root(before.superseded());
            CatalogueRoot there;
            try {
                there = after == null ? before : write(after);
            } catch (ObjectConflictException e) {
                superseded.undo();
                if (i == MOST_TRIES) throw e;
                pause(i);
                continue;
            }
            time = there.object() == null ? Instant.EPOCH : there.object().modified();
            Duration ahead = after == null
                    ? Duration.ZERO
                    : Duration.between(Instant.now(), there.object().modified());
            // What is removed is looked for in the new one: a model may have come back by this very update.
            cleanUp(there, now, ahead);
            return pages.result();
        }
    }

    /** {@return when the last update was written, by the store's clock; when it changed nothing, the one before} */
    public Instant time() {
        return time;
    }

    private CatalogueRoot write(CatalogueRoot root) throws IOException {
        StoredObject object = store.put(Upload.of(CatalogueRoot.KEY, ObjectContent.of(root.toJson()))
                .withHeaders(SiteHeaders.JSON, SiteHeaders.CHANGING)
                .withCondition(Condition.replacing(root.object())));
        return new CatalogueRoot(object, root.generation(), root.rows(), root.pages(), root.superseded());
    }

    /** Removes what was replaced long ago, then lets the catalogue name the lists of that no more. */
    private void cleanUp(CatalogueRoot there, Instant now, Duration ahead) throws IOException {
        Set<String> done = new CleanUp(store, there).run(now, ahead);
        CatalogueRoot root = there;
        for (int i = 0; i < MOST_TRIES; i++) {
            List<CatalogueRoot.Old> left = root.superseded().stream()
                    .filter(old -> !done.contains(old.file()))
                    .toList();
            if (left.size() == root.superseded().size()) return;
            try {
                write(new CatalogueRoot(root.object(), root.generation(), root.rows(), root.pages(), left));
                return;
            } catch (ObjectConflictException e) {
                pause(i);
                root = CatalogueRoot.read(store);
            }
        }
        // The next run finds that they are gone.
    }

    private void pause(int tries) throws IOException {
        try {
            Thread.sleep(1L + random.nextInt(Math.min(LONGEST_PAUSE_MILLIS, 20 << Math.min(tries, 10))));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new InterruptedIOException(store.address() + ": the update of the catalogue was ended");
        }
    }
}
