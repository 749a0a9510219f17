package org.jsmesh.site;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.jsmesh.files.AnnotationFile;
import org.jsmesh.files.AtomicFiles;
import org.jsmesh.files.EncodeJob;
import org.jsmesh.lock.LockedFile;
import org.jsmesh.objects.FolderObjectStore;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.store.Archive;
import org.jsmesh.store.ModelPage;

/**
 * A folder or a part of a bucket that any static host can serve, with the addresses of the servlet:
 *
 * <pre>
 *     index.html, viewer/             the page; its files also packed, beside them, for hosts that send these
 *     m/index.json                    catalogue
 *     m/page-{hash}.json              its further pages, where there are more than 1000 models
 *     m/superseded-{uuid}.json        what was replaced and will be removed
 *     m/{id}/index.html               page of a model
 *     m/{id}/manifest.json
 *     m/{id}/annotations.json         where the model has some
 *     m/{id}/{archiveSha256}.jsm
 *     m/{id}/{archiveSha256}/         the archive's first bytes, and its poster
 * </pre>
 *
 * Addresses in it are relative, so it may lie below any path of a host. Every object is written whole or not at all.
 * The order of writing keeps objects from naming others that are not there yet. An object that would not change is left
 * alone. A run needs time for what it changes, not for what stands: only where there are 1000 models or fewer, it also
 * brings the pages of all models up to date with the site's own. In larger sites a model's page stays as it was
 * written, and so do the files that it needs.
 *
 * <p>Only one run at a time writes to a folder. In a bucket several may; none loses what others publish. Readers are
 * not affected. Not thread-safe.
 */
public final class StaticSite implements AutoCloseable {
    private static final String INDEX = "index.html";
    private static final String TO_THE_PAGE =
            "<!doctype html><meta charset=\"utf-8\"><meta http-equiv=\"refresh\" content=\"0; url=../\"><a href=\"../\">Models</a>\n";

    /** Files that are named after what is in them. */
    private static final Pattern NAMED = Pattern.compile("viewer/.*-[A-Z0-9]{8}\\..*");

    private final ObjectStore store;
    private final Path folder; // null for a bucket
    private final SortedMap<String, byte[]> page;
    private final Path staging;
    private final LockedFile lock; // null for a bucket
    private final SortedMap<String, CatalogueRow> published = new TreeMap<>();
    private String publicUrl; // null while it is not known
    private ModelPublisher publisher; // null until something is written

    private StaticSite(ObjectStore store, Path folder, SortedMap<String, byte[]> page, Path staging, LockedFile lock) {
        this.store = store;
        this.folder = folder;
        this.page = page;
        this.staging = staging;
        this.lock = lock;
    }

    /**
     * Opens or begins a site in a folder.
     *
     * @param folder of the site, made when it is missing
     * @param page files of the page by their paths relative to the site, which have slashes; {@code index.html} among
     *     them
     * @return the site, locked against other runs until it is closed
     * @throws FileSystemException that says why, when the folder is a file, holds another site, is being written by
     *     somebody else or cannot be written
     */
    public static StaticSite open(Path folder, SortedMap<String, byte[]> page) throws IOException {
        if (Files.exists(folder) && !Files.isDirectory(folder)) {
            throw new FileSystemException(
                    folder.toString(), null, "is a file, but a site needs a folder. Choose another place");
        }
        Path place = folder.toAbsolutePath().normalize();
        FolderObjectStore store = new FolderObjectStore(place);
        OwnPage.check(store, folder.resolve(INDEX).toString());
        Files.createDirectories(place);
        Path staging = place.resolve(".encoding");
        StaticSite site = new StaticSite(store, place, new TreeMap<>(page), staging, lock(folder));
        try {
            FolderTree.remove(staging);
            return site;
        } catch (IOException e) {
            site.close();
            throw e;
        }
    }

    /**
     * Opens or begins a site in a bucket.
     *
     * @param store of the site, closed with it; a {@link FolderObjectStore} is opened as a folder
     * @param page files of the page as for a folder
     * @return the site, to which others may write at the same time
     * @throws FileSystemException that says why, when another site is there, or the bucket cannot be read
     */
    public static StaticSite open(ObjectStore store, SortedMap<String, byte[]> page) throws IOException {
        if (store instanceof FolderObjectStore files) return open(files.folder(), page);
        try {
            OwnPage.check(store, store.address() + "/" + INDEX);
            return new StaticSite(store, null, new TreeMap<>(page), Files.createTempDirectory("jsm-site"), null);
        } catch (IOException e) {
            store.close();
            throw e;
        }
    }

    private static LockedFile lock(Path folder) throws IOException {
        LockedFile lock = LockedFile.tryLock(folder.resolve(".jsm-site.lock"));
        if (lock == null) {
            throw new FileSystemException(
                    folder.toString(), null, "is being written by another run. Wait until that has ended");
        }
        return lock;
    }

    /**
     * Says where visitors find the site. Pages of models then tell those who show links to them where their poster is.
     *
     * @param address of the site, which ends with a slash
     * @return this
     */
    public StaticSite at(String address) {
        publicUrl = address;
        return this;
    }

    /**
     * {@return the folder to encode archives to: for a folder, on the site's own disk and hidden from its visitors;
     * removed by {@link #close}, and made by whoever writes there}
     */
    public Path staging() {
        return staging;
    }

    /**
     * Gives models the ids that the servlet would give them.
     *
     * @param jobs of all models of a run, with outputs in {@link #staging}
     * @return an id per job, in the order of the jobs; no two are equal
     */
    public List<String> ids(List<EncodeJob> jobs) {
        return SiteIds.of(jobs, staging);
    }

    /**
     * Publishes the archive of a model: moves it from the staging folder to its place, then names it in the model's
     * manifest. The catalogue has it when the run is finished.
     *
     * @param id of the model
     * @param job that made the archive
     * @return the place of the archive
     * @throws IOException when the output of the job is no whole archive, or the site cannot be written
     */
    public String publish(String id, EncodeJob job) throws IOException {
        begin();
        Path notes = AnnotationFile.beside(job.input());
        byte[] annotations = notes == null ? null : AnnotationFile.read(notes);
        try (Archive archive = Archive.open(job.output())) {
            String key = ModelKeys.key(id, archive.sha256() + ".jsm");
            Path place = job.output();
            if (folder != null) {
                place = folder.resolve(key);
                Files.createDirectories(folder.resolve("m").resolve(id));
                if (!Files.isRegularFile(place) || Files.mismatch(job.output(), place) >= 0)
                    AtomicFiles.move(job.output(), place);
            }
            published.put(id, publisher.publish(id, SiteIds.name(job), archive, place, annotations));
            return folder != null ? place.toString() : store.address() + "/" + key;
        }
    }

    /** Writes the files that pages of models name. */
    private void begin() throws IOException {
        if (publisher != null) return;
        for (Map.Entry<String, byte[]> file : page.entrySet()) {
            if (!file.getKey().equals(INDEX)) write(file.getKey(), file.getValue());
        }
        publisher = new ModelPublisher(store, page.get(INDEX), publicUrl, folder != null);
    }

    private void write(String key, byte[] content) throws IOException {
        String cache = NAMED.matcher(key).matches() ? SiteHeaders.FOR_EVER : SiteHeaders.CHANGING;
        ModelPublisher.write(store, key, content, SiteHeaders.type(key), cache);
    }

    /**
     * Writes the catalogue of everything that is published, brings pages of models up to date and writes the page, then
     * removes archives that were replaced more than a day ago, and in a folder such files of the page.
     *
     * @throws IOException when the site cannot be read or written
     */
    public void finish() throws IOException {
        begin();
        write("m/" + INDEX, TO_THE_PAGE.getBytes(StandardCharsets.UTF_8));
        long total = new CatalogueWriter(store).update(published.values()).total();
        boolean isSmall = total <= ModelPage.MOST;
        // The page comes behind those of models: a run that finds the same page need not look at them.
        if (isSmall && (folder != null || !Arrays.equals(ModelPublisher.read(store, INDEX), page.get(INDEX))))
            updatePages();
        write(INDEX, page.get(INDEX));
        if (isSmall && folder != null) OldPages.remove(folder, page.keySet(), INDEX, Instant.now());
    }

    /** Whether the locale of this process can name the model's files. Those of others stay as they are. */
    private boolean isNameable(String id) {
        try {
            return folder == null || folder.resolve(id) != null;
        } catch (InvalidPathException e) {
            return false;
        }
    }

    private void updatePages() throws IOException {
        PageUpdate pages = new PageUpdate(store, publisher);
        new CatalogueReader(store).forEach(row -> {
            if (!isNameable(row.id())) return;
            if (!published.containsKey(row.id())) pages.update(row.id());
            if (folder != null) removeOldArchives(row.id());
        });
    }

    private void removeOldArchives(String id) throws IOException {
        byte[] manifest = ModelPublisher.read(store, ModelKeys.manifest(id));
        if (manifest == null) return;
        String hash =
                CatalogueJson.JSON.readTree(manifest).path("archiveSha256").asText();
        Path model = folder.resolve("m").resolve(id);
        Instant written = Files.getLastModifiedTime(folder.resolve(ModelKeys.manifest(id)))
                .toInstant();
        OldArchives.remove(model, hash + ".jsm", written, Instant.now());
    }

    /**
     * Removes models from the site whose ids are not among these. Their files go at once, unless somebody else
     * publishes such a model at the same time.
     *
     * @param ids of the models that stay; those that are not in the site have no effect
     * @throws IOException when the site cannot be read or written
     */
    public void keepOnly(Collection<String> ids) throws IOException {
        Set<String> kept = new HashSet<>(ids);
        List<CatalogueRow> gone = new ArrayList<>();
        new CatalogueReader(store).forEach(row -> {
            if (!kept.contains(row.id())) gone.add(CatalogueRow.removal(row.id()));
        });
        // The catalogue no longer names them when they go.
        if (gone.isEmpty()) return;
        CatalogueWriter writer = new CatalogueWriter(store);
        writer.update(gone);
        if (folder != null) {
            for (CatalogueRow model : gone)
                FolderTree.remove(folder.resolve("m").resolve(model.id()));
            return;
        }
        RemovedModels removed = new RemovedModels(store, writer.time());
        for (CatalogueRow model : gone) removed.remove(model.id());
    }

    /** Ends the run: leaves nothing behind but the site. */
    @Override
    public void close() throws IOException {
        try (lock;
                store) {
            FolderTree.remove(staging);
        }
    }
}
