package org.jsmesh.store;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ConcurrentHashMap;
import org.jsmesh.files.Explanation;
import org.jsmesh.upload.UploadQueue;
import org.jsmesh.upload.UploadSettings;

/**
 * The models of a folder, or of one file, by id. Each becomes an archive on first demand: archives are mapped, model
 * files are encoded. There is one encoding at a time per model; everybody else who asks for the model waits. The store
 * notices changes of the folder when somebody asks for the catalogue or an unknown id, and changes of a file when
 * somebody asks for its archive. Thread-safe.
 */
public final class ModelStore implements AutoCloseable {
    private static final Logger LOG = System.getLogger(ModelStore.class.getName());
    private static final long RESCAN_NANOS = 1_000_000_000L;

    private final StoreSettings settings;
    private final Preparer preparer;
    private final ConcurrentHashMap<String, Preparation> preparations = new ConcurrentHashMap<>();
    private final SharedTask scan = new SharedTask(this::scan);
    private volatile FolderScan found = FolderScan.none();
    private volatile long scannedNanos;
    private volatile UploadQueue uploads;

    /** Files whose names the log has been told of. */
    private final Set<String> told = ConcurrentHashMap.newKeySet();

    /**
     * Looks at the folder once; no archive is read yet.
     *
     * @param settings which folder or file, and where archives are kept
     * @param encoder makes archives of model files
     * @throws IOException when the folder or file does not exist or cannot be listed, or the cache folder cannot be
     *     written
     */
    public ModelStore(StoreSettings settings, ModelEncoder encoder) throws IOException {
        this(settings, encoder, HeaderReader.DECODER);
    }

    ModelStore(StoreSettings settings, ModelEncoder encoder, HeaderReader reader) throws IOException {
        this.settings = settings;
        if (!Files.exists(settings.source()))
            throw new NoSuchFileException(settings.source().toString());
        preparer = new Preparer(settings, encoder, reader);
        scan.run();
    }

    /**
     * Accepts models that clients send from now on, and goes on with those that were sent before. Their archives are
     * kept in the folder {@code uploads} in the store's folder.
     *
     * @param granted who may send, and how much
     * @throws IOException when the store's folder takes no files or is none
     */
    public void acceptUploads(UploadSettings granted) throws IOException {
        if (!Files.isDirectory(settings.source())) {
            throw new NotDirectoryException(settings.source().toString());
        }
        uploads = UploadQueue.open(granted, settings.source().resolve("uploads"), this::lookAgain);
    }

    /** {@return the models that clients send; null when they may not} */
    public UploadQueue uploads() {
        return uploads;
    }

    private void lookAgain() {
        try {
            scan.run();
        } catch (IOException e) {
            // The next request for the model looks again.
            scannedNanos = System.nanoTime() - RESCAN_NANOS;
        }
    }

    /**
     * Looks for new and removed models, then tells the state of each.
     *
     * @return a row per model, in order of their ids
     * @throws IOException when the folder cannot be listed
     */
    public List<ModelStatus> list() throws IOException {
        scan.run();
        return known();
    }

    /**
     * Tells the state of each model without looking for new and removed ones.
     *
     * @return a row per model that the last look found, in order of their ids
     * @throws IOException not at present: a model whose file cannot be read is {@link ModelStatus.State#NEW}
     */
    public List<ModelStatus> known() throws IOException {
        List<ModelStatus> list = new ArrayList<>();
        for (ModelEntry entry : found.entries().values()) list.add(status(entry));
        return list;
    }

    /**
     * {@return true when the last look at the folder found a model of that id; this call looks at no file}
     *
     * @param id any text
     */
    public boolean isKnown(String id) {
        return found.find(id) != null;
    }

    /**
     * Finds a model. For an unknown id it looks at the folder again when the last look is more than a second old.
     *
     * @param id any text
     * @return the model, if there is one
     * @throws IOException when it looks at the folder and cannot list it
     */
    public Optional<ModelEntry> find(String id) throws IOException {
        ModelEntry entry = found.find(id);
        if (entry == null && System.nanoTime() - scannedNanos > RESCAN_NANOS) {
            scan.run();
            entry = found.find(id);
        }
        return Optional.ofNullable(entry);
    }

    /**
     * {@return the model of that file; null when the last look at the folder found none}
     *
     * @param file its path, below the store's folder as the settings name it
     */
    public ModelEntry of(Path file) {
        for (ModelEntry entry : found.entries().values()) if (entry.path().equals(file)) return entry;
        return null;
    }

    /**
     * A file of the folder, not one that was sent, that keeps a model sent under that id from getting it: the file has
     * the id, or a name that would give it. Only while uploads are accepted.
     *
     * @param id that a client wants to send a model under
     * @return the model of that file; null when there is none
     * @throws IOException when it looks at the folder and cannot list it
     */
    public ModelEntry inTheWayOf(String id) throws IOException {
        // Looks at the folder again when the last look was long ago.
        ModelEntry there = find(id).orElse(null);
        if (there != null && !uploads.owns(there.path())) return there;
        for (ModelEntry entry : found.entries().values()) {
            if (ModelEntry.idOf(entry.name()).equals(id) && !uploads.owns(entry.path())) return entry;
        }
        return null;
    }

    /**
     * The archive of a model as its file is now. It is encoded or mapped unless that has happened before.
     *
     * @param entry of this store
     * @return completes on another thread; exceptionally with {@link ModelUnavailableException}
     * @throws ModelUnavailableException when the file is gone
     */
    public CompletableFuture<Archive> archive(ModelEntry entry) throws ModelUnavailableException {
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

    /**
     * The archive of a model without a look at its file. It is for requests that name the archive by its hash. They
     * come in great numbers, and the bytes under a hash stay right when the file is replaced.
     *
     * @param entry of this store
     * @return the archive; null when it is not there yet, or its file was not looked at within the last tenth of a
     *     second
     */
    public Archive recent(ModelEntry entry) {
        Preparation known = preparations.get(entry.id());
        if (known == null || !known.isRecent(entry)) return null;
        return known.archive().isCompletedExceptionally()
                ? null
                : known.archive().getNow(null);
    }

    private ModelStatus status(ModelEntry entry) {
        Preparation preparation = preparations.get(entry.id());
        if (preparation == null || !isCurrent(preparation, entry)) {
            return new ModelStatus(entry, ModelStatus.State.NEW, null, null, 0, null);
        }
        if (!preparation.archive().isDone()) {
            String stage = preparation.stage();
            return new ModelStatus(entry, ModelStatus.State.PREPARING, null, stage, preparation.fraction(), null);
        }
        try {
            return new ModelStatus(
                    entry, ModelStatus.State.READY, preparation.archive().join(), null, 1, null);
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

    private void scan() throws IOException {
        FolderScan scanned = FolderScan.scan(settings.source());
        for (FileSystemException e : scanned.skipped()) {
            // Once for each, though every look at the folder finds it again.
            if (told.add(e.getFile()))
                LOG.log(Level.WARNING, Explanation.of(null, e).toString());
        }
        found = scanned;
        scannedNanos = System.nanoTime();
        preparations.forEach((id, preparation) -> {
            if (!scanned.entries().containsKey(id) && preparations.remove(id, preparation)) preparation.cancel();
        });
    }

    /** {@return the number of models that wait to be encoded} */
    public int waitingEncodings() {
        return preparer.waiting();
    }

    /** {@return the number of models that are being encoded} */
    public int runningEncodings() {
        return preparer.running();
    }

    /** {@return the number of models that have been encoded since the start} */
    public long doneEncodings() {
        return preparer.done();
    }

    /** {@return the number of encodings that have failed or were cancelled since the start} */
    public long failedEncodings() {
        return preparer.failed();
    }

    /** Gives up running encodings. Archives that are being sent stay readable. */
    @Override
    public void close() {
        if (uploads != null) uploads.close();
        // In this order, so that a cancelled request knows why.
        preparer.close();
        preparations.values().forEach(Preparation::cancel);
    }
}
