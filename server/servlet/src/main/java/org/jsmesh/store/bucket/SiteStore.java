package org.jsmesh.store.bucket;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.net.URI;
import java.nio.file.FileSystemException;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.TimeUnit;
import org.jsmesh.files.AnnotationFile;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.store.ModelSource;
import org.jsmesh.store.ModelUnavailableException;
import org.jsmesh.store.ServedArchive;

/**
 * The models of a site that {@code jsm encode --site} has written to a store of objects. Nothing is listed: the
 * catalogue is read by the page, a model is found by the key of its manifest, and an archive is read by ranges. What
 * was used last stays in memory within bounds. No call waits for the store, but for {@link #open} and {@link #check}.
 * Thread-safe.
 */
public final class SiteStore implements ModelSource {
    /** What {@link org.jsmesh.objects.ObjectStores#open(String, Duration)} should be told for the objects of a site. */
    public static final Duration PATIENCE = Duration.ofSeconds(12);

    private static final String MODELS = "m/";
    private static final String ROOT = MODELS + "index.json";
    private static final String MANIFEST = "/manifest.json";

    /** How long a catalogue or manifest may be out of date. */
    private static final long FRESH_NANOS = TimeUnit.SECONDS.toNanos(5);

    /** More than {@link #PATIENCE}, so that the store's own reason is told. */
    private static final long READ_MILLIS = 15_000;

    private static final long HEALTH_MILLIS = 3000;
    private static final int SHARE_OF_SMALL = 4;

    private final ObjectStore objects;
    private final SiteSettings settings;
    private final Reads reads;
    private final SmallObjects small;
    private final BlockCache blocks;
    private final SiteArchives archives;
    private volatile SmallObject counted;
    private volatile int total;

    private SiteStore(ObjectStore objects, SiteSettings settings, long readMillis, int blockBytes) {
        this.objects = objects;
        this.settings = settings;
        reads = new Reads(objects.address(), readMillis);
        small = new SmallObjects(objects, reads, settings.memoryBytes() / SHARE_OF_SMALL, System::nanoTime);
        blocks = new BlockCache(objects, reads, settings.memoryBytes(), blockBytes);
        archives = new SiteArchives(objects, reads, blocks, System::nanoTime);
    }

    /**
     * Looks whether there is a site.
     *
     * @param objects that hold it; the caller closes them after this store
     * @param settings how it is read
     * @return the site
     * @throws FileSystemException when there is none, with a remedy
     * @throws IOException when the store cannot be read
     */
    public static SiteStore open(ObjectStore objects, SiteSettings settings) throws IOException {
        return open(objects, settings, READ_MILLIS, BlockCache.BLOCK_BYTES);
    }

    /**
     * @param readMillis the longest that a request to the store may take
     * @param blockBytes that are read at a time
     */
    static SiteStore open(ObjectStore objects, SiteSettings settings, long readMillis, int blockBytes)
            throws IOException {
        if (objects.find(ROOT).isEmpty())
            throw new FileSystemException(
                    objects.address(),
                    null,
                    "holds no site. Make one with 'jsm encode --site " + objects.address() + "', or check the prefix");
        if (settings.redirect() != null
                && objects.signedAddress(ROOT, settings.redirect()).isEmpty())
            throw new FileSystemException(
                    objects.address(), null, "has no addresses to send clients to. Serve it without --redirect");
        return new SiteStore(objects, settings, readMillis, blockBytes);
    }

    /**
     * A page of the catalogue as it lies in the store.
     *
     * @param name of the file, {@code index.json} for the first one
     * @param isImmutable whether the file never changes, so that it need not be looked at again
     * @return completes with null when there is none, exceptionally with {@link ModelUnavailableException}
     */
    public CompletableFuture<byte[]> catalogue(String name, boolean isImmutable) {
        return read(MODELS + name, isImmutable ? Long.MAX_VALUE : FRESH_NANOS);
    }

    /** One array as long as the object stays as it is. */
    private CompletableFuture<byte[]> read(String key, long freshNanos) {
        return small.get(key, freshNanos).thenApply(object -> object == null ? null : object.content());
    }

    /**
     * Finds a model.
     *
     * @param id of letters, digits and hyphens
     * @return completes with the model; exceptionally with {@link ModelUnavailableException}, also when there is none
     */
    public CompletableFuture<SiteModel> model(String id) {
        return small.get(MODELS + id + MANIFEST, FRESH_NANOS).thenApply(object -> {
            try {
                if (object == null) throw ModelUnavailableException.absent("there is no such model");
                return SiteModel.of(id, object.content());
            } catch (ModelUnavailableException e) {
                throw new CompletionException(e);
            }
        });
    }

    /**
     * What people wrote about places of a model.
     *
     * @param id of the model
     * @return completes with the JSON, or with null when there is none
     */
    public CompletableFuture<byte[]> annotations(String id) {
        return read(MODELS + id + "/" + AnnotationFile.NAME, FRESH_NANOS);
    }

    private static String key(String id, String sha256) {
        return MODELS + id + "/" + sha256 + ".jsm";
    }

    /**
     * An archive of a model. One that was replaced is served as long as it is in the store.
     *
     * @param id of the model
     * @param sha256 of the archive
     * @return completes with the archive, or with null when there is none; exceptionally with
     *     {@link ModelUnavailableException}
     */
    public CompletableFuture<? extends ServedArchive> archive(String id, String sha256) {
        return archives.open(key(id, sha256), sha256);
    }

    /**
     * The same if it was used within the last minute.
     *
     * @param id of the model
     * @param sha256 of the archive
     * @return null when it must be opened
     */
    public ServedArchive recent(String id, String sha256) {
        return archives.recent(key(id, sha256));
    }

    /**
     * An address of the store where anybody can read an archive.
     *
     * @param id of the model
     * @param sha256 of the archive
     * @return empty when bytes are sent
     */
    public Optional<URI> redirect(String id, String sha256) {
        return settings.redirect() == null
                ? Optional.empty()
                : objects.signedAddress(key(id, sha256), settings.redirect());
    }

    /** {@return how the site is read} */
    public SiteSettings settings() {
        return settings;
    }

    /**
     * No request holds a thread while the store is read. But addresses of the store are signed at once, with
     * credentials that may have to be fetched.
     */
    @Override
    public boolean isKnown(String id) {
        return settings.redirect() == null;
    }

    @Override
    public void check() throws IOException {
        SmallObject root;
        try {
            root = small.get(ROOT, FRESH_NANOS).get(HEALTH_MILLIS, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("the check was interrupted", e);
        } catch (Exception e) {
            throw new IOException(objects.address() + " cannot be read", e);
        }
        if (root == null) throw new FileSystemException(objects.address(), null, "holds no site any more");
        count(root);
    }

    private void count(SmallObject root) throws IOException {
        if (root == counted) return;
        try (JsonParser json = new JsonFactory().createParser(root.content())) {
            json.nextToken();
            while (json.nextToken() == JsonToken.FIELD_NAME) {
                boolean isTotal = json.currentName().equals("total");
                json.nextToken();
                if (isTotal) total = json.getIntValue();
                if (isTotal) break;
                json.skipChildren();
            }
        }
        counted = root;
    }

    /** {@return the number of models when the catalogue was checked last} */
    public int models() {
        return total;
    }

    /** {@return requests to the store that have been answered since the start} */
    public long doneReads() {
        return reads.done();
    }

    /** {@return requests to the store that have failed or were given up since the start} */
    public long failedReads() {
        return reads.failed();
    }

    /** {@return requests to the store that wait for a thread} */
    public int waitingReads() {
        return reads.waiting();
    }

    /** {@return bytes of archives that were read from the store since the start} */
    public long readBytes() {
        return blocks.readBytes();
    }

    /** {@return bytes of archives in memory} */
    public long keptBytes() {
        return blocks.keptBytes();
    }

    /** Gives up what is being read. */
    @Override
    public void close() {
        reads.close();
    }
}
