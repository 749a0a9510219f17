package org.jsmesh.store;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.jsmesh.sandbox.ModelEncoder;
import org.jsmesh.store.ids.ModelPath;
import org.jsmesh.upload.UploadQueue;
import org.jsmesh.upload.UploadSettings;

/**
 * The models of a folder, or of one file, by id. Each becomes an archive on first demand: archives are opened, model
 * files are encoded. There is one encoding at a time per model; everybody else who asks for the model waits. The store
 * follows changes of the folder on a thread of its own, within about a second, and notices changes of a file at the
 * latest when somebody asks for its archive. Thread-safe.
 */
public final class ModelStore implements ModelSource {
    private final StoreSettings settings;
    private final ModelFolder folder;
    private final ModelArchives archives;
    private volatile UploadQueue uploads;

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
        folder = new ModelFolder(settings.source(), this::status, this::forgetRemoved);
        try {
            archives = new ModelArchives(settings, encoder, reader);
        } catch (IOException | RuntimeException e) {
            folder.close();
            throw e;
        }
        archives.counts().listen(folder::touched);
        try {
            folder.open();
        } catch (IOException | RuntimeException e) {
            close();
            throw e;
        }
    }

    private void forgetRemoved() {
        archives.keepOnly(folder::has);
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
        uploads = UploadQueue.open(
                granted, settings.source().resolve(ModelPath.UPLOADS), () -> folder.lookInto(ModelPath.UPLOADS));
    }

    /** {@return the models that clients send; null when they may not} */
    public UploadQueue uploads() {
        return uploads;
    }

    /**
     * Looks at every file of the folder, then tells the state of each model. This takes seconds in a folder of a
     * hundred thousand files; {@link #page} takes none.
     *
     * @return a row per model, in order of their ids
     * @throws IOException when the folder cannot be listed
     */
    public List<ModelStatus> list() throws IOException {
        folder.look();
        return known();
    }

    /**
     * Tells the state of each model without looking for new and removed ones.
     *
     * @return a row per model that is known, in order of their ids
     */
    public List<ModelStatus> known() {
        return folder.entries().stream().map(archives::status).toList();
    }

    /**
     * Tells the state of some models without looking at the folder: new and removed ones show about a second after they
     * came or went.
     *
     * @param after begins behind that id, whether or not a model has it; null for the beginning
     * @return a page of the list of models
     */
    public ModelPage page(String after) {
        return folder.page(after);
    }

    /**
     * Tells whether the folder could be read when it was looked at last; looks at nothing.
     *
     * @throws IOException the reason why not
     */
    @Override
    public void check() throws IOException {
        folder.check();
    }

    /**
     * Counts models without looking at each.
     *
     * @param state to count models in
     * @return the number of models in that state
     */
    public int count(ModelStatus.State state) {
        if (state != ModelStatus.State.NEW) return archives.counts().count(state);
        int others = 0;
        for (ModelStatus.State one : ModelStatus.State.values())
            others += archives.counts().count(one);
        return Math.max(0, folder.size() - others);
    }

    /**
     * {@return true when the last look at the folder found a model of that id; this call looks at no file}
     *
     * @param id any text
     */
    @Override
    public boolean isKnown(String id) {
        return folder.known(id) != null;
    }

    /**
     * Finds a model. For an unknown id it looks at folders that have changed, a few times in a second at most.
     *
     * @param id any text
     * @return the model, if there is one
     * @throws IOException when it looks at the folder and cannot list it
     */
    public Optional<ModelEntry> find(String id) throws IOException {
        return Optional.ofNullable(folder.find(id));
    }

    /**
     * {@return the model of that file; null when the last look at the folder found none}
     *
     * @param file its path, below the store's folder as the settings name it
     */
    public ModelEntry of(Path file) {
        return folder.of(file);
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
        return folder.inTheWayOf(id, uploads::owns);
    }

    /**
     * The archive of a model as its file is now. It is encoded or opened unless that has happened before. The wish
     * lasts until it is fulfilled.
     *
     * @param entry of this store
     * @return completes on another thread; exceptionally with {@link ModelUnavailableException}. The archive stays open
     *     while it is among those that were used last, and as long as a reader of it is open
     * @throws ModelUnavailableException when the file is gone, or too many models wait
     */
    public CompletableFuture<Archive> archive(ModelEntry entry) throws ModelUnavailableException {
        return archives.archive(entry, null);
    }

    /**
     * The same for a client that asks again until the archive is there. If it does not for half a minute, and nobody
     * else does, its wish is forgotten.
     *
     * @param entry of this store
     * @param client that asks, any text such as its address
     * @return as above
     * @throws ModelUnavailableException also when too many models wait that this client has asked for
     */
    public CompletableFuture<Archive> archive(ModelEntry entry, String client) throws ModelUnavailableException {
        return archives.archive(entry, client);
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
        return archives.recent(entry);
    }

    /**
     * Tells the state of a model, as far as it is known without a look at its file.
     *
     * @param entry of this store
     * @return its state
     */
    public ModelStatus status(ModelEntry entry) {
        return archives.status(entry);
    }

    /**
     * {@return true when an archive of the model is looked for or opened at the moment, which takes no encoding}
     *
     * @param entry of this store
     */
    public boolean isOpening(ModelEntry entry) {
        return archives.isOpening(entry);
    }

    /** {@return the number of models that wait to be encoded} */
    public int waitingEncodings() {
        return archives.preparer().waiting();
    }

    /** {@return the number of models that are being encoded} */
    public int runningEncodings() {
        return archives.preparer().running();
    }

    /** {@return the number of models that have been encoded since the start} */
    public long doneEncodings() {
        return archives.preparer().done();
    }

    /** {@return the number of encodings that have failed or were cancelled since the start} */
    public long failedEncodings() {
        return archives.preparer().failed();
    }

    /** Gives up running encodings. Archives that are being sent stay readable. */
    @Override
    public void close() {
        if (uploads != null) uploads.close();
        folder.close();
        archives.close();
    }
}
