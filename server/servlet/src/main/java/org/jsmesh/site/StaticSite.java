package org.jsmesh.site;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Instant;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.jsmesh.files.ArchiveReport;
import org.jsmesh.files.AtomicFiles;
import org.jsmesh.files.EncodeJob;
import org.jsmesh.lock.LockedFile;
import org.jsmesh.store.Archive;

/**
 * A folder that any static host can serve, with the addresses of the servlet:
 *
 * <pre>
 *     index.html, viewer/             the page
 *     m/index.json                    catalogue
 *     m/{id}/manifest.json
 *     m/{id}/{archiveSha256}.jsm
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

    /** A file that the page of this project refers to, and hardly any other page. */
    private static final String MARK = "viewer/app.js";

    private final Path folder;
    private final SortedMap<String, byte[]> page;
    private final Path models;
    private final Path staging;
    private final LockedFile lock;

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
                && !Files.readString(start, StandardCharsets.ISO_8859_1).contains(MARK)) {
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
        Archive archive = Archive.open(job.output());
        Path place = models.resolve(id).resolve(archive.sha256() + ".jsm");
        Files.createDirectories(models.resolve(id));
        if (!Files.isRegularFile(place) || Files.mismatch(job.output(), place) >= 0) {
            Files.move(job.output(), place, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        }
        ArchiveReport report = ArchiveReport.of(archive.header(), archive.sha256());
        String manifest = report.toManifestJson(id, SiteIds.name(job), archive.sha256() + ".jsm");
        write(models.resolve(id).resolve(MANIFEST), manifest.getBytes(StandardCharsets.UTF_8));
        return place;
    }

    /**
     * Writes the page and the catalogue of everything that is published, then removes archives that were replaced more
     * than a day ago.
     *
     * @throws IOException when the site cannot be read or written
     */
    public void finish() throws IOException {
        TreeSet<String> ids = published();
        for (Map.Entry<String, byte[]> file : page.entrySet()) {
            if (!file.getKey().equals(INDEX)) write(folder.resolve(file.getKey()), file.getValue());
        }
        write(folder.resolve(INDEX), page.get(INDEX));
        write(models.resolve(INDEX), TO_THE_PAGE.getBytes(StandardCharsets.UTF_8));
        write(models.resolve("index.json"), SiteCatalogue.json(models, ids));
        for (String id : ids) {
            Path model = models.resolve(id);
            JsonNode manifest = SiteCatalogue.manifest(models, id);
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
        TreeSet<String> kept = published();
        TreeSet<String> gone = new TreeSet<>(kept);
        kept.retainAll(ids);
        gone.removeAll(kept);
        // The catalogue no longer names them when they go.
        if (!gone.isEmpty()) write(models.resolve("index.json"), SiteCatalogue.json(models, kept));
        for (String id : gone) clear(models.resolve(id));
    }

    private TreeSet<String> published() throws IOException {
        TreeSet<String> ids = new TreeSet<>();
        if (!Files.isDirectory(models)) return ids;
        try (DirectoryStream<Path> folders = Files.newDirectoryStream(models, Files::isDirectory)) {
            for (Path model : folders) {
                String id = String.valueOf(model.getFileName());
                if (SiteCatalogue.manifest(models, id) != null) ids.add(id);
            }
        }
        return ids;
    }

    private static void write(Path file, byte[] content) throws IOException {
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
