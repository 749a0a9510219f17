package org.jsmesh.site;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.files.AnnotationFile;
import org.jsmesh.files.ArchiveParts;
import org.jsmesh.files.ArchiveReport;
import org.jsmesh.files.AtomicFiles;
import org.jsmesh.files.EncodeJob;
import org.jsmesh.files.PathNames;
import org.jsmesh.lock.LockedFile;
import org.jsmesh.store.Archive;

/**
 * A folder that any static host can serve, with the addresses of the servlet:
 *
 * <pre>
 *     index.html, viewer/             the page; its files also packed, beside them, for hosts that send these
 *     m/index.json                    catalogue
 *     m/after-{id}.json               its further pages, where there are more than 1000 models
 *     m/{id}/index.html               page of a model
 *     m/{id}/manifest.json
 *     m/{id}/annotations.json         where the model has some
 *     m/{id}/{archiveSha256}.jsm
 *     m/{id}/{archiveSha256}/         the archive's first bytes, and its poster
 * </pre>
 *
 * Addresses in it are relative, so it may lie below any path of a host. Every file is written whole or not at all. The
 * order of writing keeps files from naming others that are not there yet. A file that would not change is left alone.
 * Only one run at a time writes; readers are not affected. Not thread-safe.
 */
public final class StaticSite implements AutoCloseable {
    private static final String INDEX = "index.html";
    private static final String MANIFEST = "manifest.json";
    private static final String TO_THE_PAGE =
            "<!doctype html><meta charset=\"utf-8\"><meta http-equiv=\"refresh\" content=\"0; url=../\"><a href=\"../\">Models</a>\n";

    /** What the page of this project says of itself, now and before. */
    private static final Pattern MARK =
            Pattern.compile("<meta name=\"generator\" content=\"jSM\\b|src=\"viewer/page/app\\.js\"");

    private final Path folder;
    private final SortedMap<String, byte[]> page;
    private final Path models;
    private final Path staging;
    private final LockedFile lock;
    private String publicUrl; // null while it is not known

    private StaticSite(Path folder, SortedMap<String, byte[]> page, LockedFile lock) {
        this.folder = folder;
        this.page = page;
        this.lock = lock;
        models = folder.resolve("m");
        staging = folder.resolve(".encoding");
    }

    /**
     * Opens or begins a site.
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
        Path start = folder.resolve(INDEX);
        if (Files.exists(start)
                && !MARK.matcher(Files.readString(start, StandardCharsets.ISO_8859_1))
                        .find()) {
            throw new FileSystemException(
                    start.toString(), null, "is a page of another site, nothing is written. Choose another folder");
        }
        Files.createDirectories(folder);
        StaticSite site = new StaticSite(folder.toAbsolutePath().normalize(), new TreeMap<>(page), lock(folder));
        try {
            site.clear(site.staging);
            return site;
        } catch (IOException e) {
            site.close();
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
     * {@return the folder to encode archives to, on the site's own disk and hidden from its visitors; removed by
     * {@link #close}, and made by whoever writes there}
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
     * manifest.
     *
     * @param id of the model
     * @param job that made the archive
     * @return the place of the archive
     * @throws IOException when the output of the job is no whole archive, or the site cannot be written
     */
    public Path publish(String id, EncodeJob job) throws IOException {
        try (Archive archive = Archive.open(job.output())) {
            return publish(id, job, archive);
        }
    }

    private Path publish(String id, EncodeJob job, Archive archive) throws IOException {
        Path place = models.resolve(id).resolve(archive.sha256() + ".jsm");
        Files.createDirectories(models.resolve(id));
        if (!Files.isRegularFile(place) || Files.mismatch(job.output(), place) >= 0) {
            AtomicFiles.move(job.output(), place);
        }
        writeParts(archive, place.resolveSibling(archive.sha256()));
        ArchiveReport report = ArchiveReport.of(archive.header(), archive.sha256());
        boolean hasAnnotations = publishAnnotations(id, job);
        String annotations = hasAnnotations ? AnnotationFile.NAME : null;
        String manifest = report.toManifestJson(id, SiteIds.name(job), archive.sha256() + ".jsm", annotations);
        write(models.resolve(id).resolve(MANIFEST), manifest.getBytes(StandardCharsets.UTF_8));
        return place;
    }

    /** Copies what stands beside the model file; says whether there is anything. */
    private boolean publishAnnotations(String id, EncodeJob job) throws IOException {
        Path file = AnnotationFile.beside(job.input());
        Path place = models.resolve(id).resolve(AnnotationFile.NAME);
        if (file != null) write(place, AnnotationFile.read(file));
        else Files.deleteIfExists(place);
        return file != null;
    }

    /** Writes the files that a server cuts out of the archive. */
    private static void writeParts(Archive archive, Path beside) throws IOException {
        Files.createDirectories(beside);
        BatchIndex index = archive.batches();
        write(beside.resolve(ArchiveParts.FIRST), archive.copy(0, index.firstBytes()));
        int poster = index.poster();
        if (poster < 0) return;
        int length = BatchIndex.payloadBytes(index.bytes(poster));
        write(beside.resolve(ArchiveParts.POSTER), archive.copy(index.offset(poster), length));
    }

    /**
     * Writes the page and the catalogue of everything that is published, then removes archives and files of the page
     * that were replaced more than a day ago.
     *
     * @throws IOException when the site cannot be read or written
     */
    public void finish() throws IOException {
        SortedMap<String, Path> published = published();
        for (Map.Entry<String, byte[]> file : page.entrySet()) {
            if (!file.getKey().equals(INDEX)) write(folder.resolve(file.getKey()), file.getValue());
        }
        write(folder.resolve(INDEX), page.get(INDEX));
        SitePages pages = new SitePages(page.get(INDEX), publicUrl);
        for (Map.Entry<String, Path> model : published.entrySet())
            write(model.getValue().resolve(INDEX), pages.page(model.getKey(), model.getValue()));
        OldPages.remove(folder, page.keySet(), INDEX, Instant.now());
        write(models.resolve(INDEX), TO_THE_PAGE.getBytes(StandardCharsets.UTF_8));
        SiteCatalogue.write(models, published);
        for (Path model : published.values()) {
            JsonNode manifest = SiteCatalogue.manifest(model);
            Instant written = Files.getLastModifiedTime(model.resolve(MANIFEST)).toInstant();
            OldArchives.remove(model, manifest.path("archiveUrl").asText(), written, Instant.now());
        }
    }

    /**
     * Removes models from the site whose ids are not among these. Their files go at once.
     *
     * @param ids of the models that stay; those that are not in the site have no effect
     * @throws IOException when the site cannot be read or written
     */
    public void keepOnly(Collection<String> ids) throws IOException {
        SortedMap<String, Path> kept = published();
        SortedMap<String, Path> gone = new TreeMap<>(kept);
        kept.keySet().retainAll(ids);
        gone.keySet().removeAll(kept.keySet());
        // The catalogue no longer names them when they go.
        if (!gone.isEmpty()) SiteCatalogue.write(models, kept);
        for (Path model : gone.values()) clear(model);
    }

    /** The folders of the models by their ids. */
    private SortedMap<String, Path> published() throws IOException {
        SortedMap<String, Path> found = new TreeMap<>();
        if (!Files.isDirectory(models)) return found;
        try (DirectoryStream<Path> folders = Files.newDirectoryStream(models, Files::isDirectory)) {
            for (Path model : folders) {
                if (SiteCatalogue.manifest(model) != null) found.put(PathNames.name(model), model);
            }
        }
        return found;
    }

    static void write(Path file, byte[] content) throws IOException {
        boolean same = Files.isRegularFile(file)
                && Files.size(file) == content.length
                && Arrays.equals(Files.readAllBytes(file), content);
        if (!same) AtomicFiles.write(file, content);
    }

    private void clear(Path tree) throws IOException {
        if (!Files.exists(tree)) return;
        List<Path> files;
        try (Stream<Path> walk = Files.walk(tree)) {
            files = walk.sorted(Comparator.reverseOrder()).toList();
        }
        for (Path file : files) Files.deleteIfExists(file);
    }

    /** Ends the run: leaves nothing behind but the site. */
    @Override
    public void close() throws IOException {
        try {
            clear(staging);
        } finally {
            lock.close();
        }
    }
}
