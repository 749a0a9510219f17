package org.jsmesh.site;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.Map;
import java.util.Optional;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.files.AnnotationFile;
import org.jsmesh.files.ArchiveParts;
import org.jsmesh.files.ArchiveReport;
import org.jsmesh.objects.ObjectContent;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;
import org.jsmesh.objects.Upload;
import org.jsmesh.page.PageTemplate;
import org.jsmesh.store.Archive;
import org.jsmesh.store.ids.ModelIds;

/**
 * Writes the objects of models of a site: archive, its first bytes, poster, annotations, manifest, page; the manifest
 * after what it names. The rows that it gives are then put into the catalogue by one {@link CatalogueWriter}. Many may
 * write different models at once, on different machines. Objects that are there already are left alone. Thread-safe.
 */
public final class ModelPublisher {
    private final ObjectStore store;
    private final PageTemplate template;
    private final String publicUrl;

    /**
     * Writes to a site.
     *
     * @param store of the site
     * @param page {@code index.html} of the site's page, with its files' names
     * @param publicUrl address of the site, which ends with a slash; null when it is not known
     */
    public ModelPublisher(ObjectStore store, byte[] page, String publicUrl) {
        this.store = store;
        this.publicUrl = publicUrl;
        template = new PageTemplate(new String(page, StandardCharsets.UTF_8), Map.of());
    }

    /** Gives parts of an archive. */
    private interface Source {
        byte[] copy(long offset, int length) throws IOException;
    }

    /**
     * Publishes an archive that is in memory.
     *
     * @param id of the model: a name without slashes, as {@link org.jsmesh.store.ids.ModelIds} gives it
     * @param name of the model for people
     * @param archive of the model
     * @param annotations JSON of what people wrote about it; null for nothing
     * @return what the catalogue says of it
     * @throws IOException when an object cannot be written
     */
    public CatalogueRow publish(String id, String name, EncodedArchive archive, byte[] annotations) throws IOException {
        byte[] bytes = archive.bytes();
        Source source = (offset, length) -> Arrays.copyOfRange(bytes, (int) offset, (int) offset + length);
        return publish(id, name, ObjectContent.of(bytes), hash(bytes), archive.header(), annotations, source);
    }

    /**
     * Publishes an archive that is a file.
     *
     * @param id see the other method
     * @param name of the model for people
     * @param archive file that stays as it is meanwhile
     * @param annotations JSON of what people wrote about it; null for nothing
     * @return what the catalogue says of it
     * @throws IOException when the file is no whole archive, or an object cannot be written
     */
    public CatalogueRow publish(String id, String name, Path archive, byte[] annotations) throws IOException {
        try (Archive file = Archive.open(archive)) {
            return publish(id, name, file, archive, annotations);
        }
    }

    /** @param place where the bytes of the archive are */
    CatalogueRow publish(String id, String name, Archive archive, Path place, byte[] annotations) throws IOException {
        ObjectContent content = ObjectContent.of(place);
        return publish(id, name, content, archive.sha256(), archive.header(), annotations, archive::copy);
    }

    private CatalogueRow publish(
            String id,
            String name,
            ObjectContent archive,
            String hash,
            ArchiveHeader header,
            byte[] annotations,
            Source source)
            throws IOException {
        put(ModelKeys.key(id, hash + ".jsm"), archive, SiteHeaders.ARCHIVE);
        byte[] poster = putParts(id, hash, header.batches(), source);
        String notes = ModelKeys.annotations(id);
        if (annotations == null) store.delete(notes);
        else write(store, notes, annotations, SiteHeaders.JSON, SiteHeaders.CHANGING);
        String manifest = ArchiveReport.of(header, hash)
                .toManifestJson(id, name, hash + ".jsm", annotations == null ? null : AnnotationFile.NAME);
        byte[] content = manifest.getBytes(StandardCharsets.UTF_8);
        StoredObject written = write(store, ModelKeys.manifest(id), content, SiteHeaders.JSON, SiteHeaders.CHANGING);
        writePage(id, manifest, poster);
        Instant time = written.modified() == null ? Instant.now() : written.modified();
        return CatalogueJson.row(
                id, manifest, time.truncatedTo(ChronoUnit.SECONDS).toString());
    }

    /** Writes what a server cuts out of the archive; the poster, or null. */
    private byte[] putParts(String id, String hash, BatchIndex index, Source source) throws IOException {
        byte[] first = source.copy(0, index.firstBytes());
        put(ModelKeys.archive(id, hash, ArchiveParts.FIRST), ObjectContent.of(first), SiteHeaders.ARCHIVE);
        int poster = index.poster();
        if (poster < 0) return null;
        byte[] jpeg = source.copy(index.offset(poster), BatchIndex.payloadBytes(index.bytes(poster)));
        put(ModelKeys.archive(id, hash, ArchiveParts.POSTER), ObjectContent.of(jpeg), SiteHeaders.JPEG);
        return jpeg;
    }

    /** Writes the page of a model that is there. */
    void writePage(String id, String manifest, byte[] poster) throws IOException {
        String page = template.page(ModelIds.segment(id), manifest, poster, publicUrl);
        byte[] content = page.getBytes(StandardCharsets.UTF_8);
        write(store, ModelKeys.page(id), content, SiteHeaders.HTML, SiteHeaders.CHANGING);
    }

    /** Writes an object that is named after its content. */
    private void put(String key, ObjectContent content, String type) throws IOException {
        Optional<StoredObject> there = store.find(key);
        if (there.isPresent() && there.get().bytes() == content.bytes()) return;
        store.put(Upload.of(key, content).withHeaders(type, SiteHeaders.FOR_EVER));
    }

    /** Writes an object unless it is there with the same content; what is there then. */
    static StoredObject write(ObjectStore store, String key, byte[] content, String type, String cache)
            throws IOException {
        Optional<StoredObject> there = store.find(key);
        if (there.isPresent() && there.get().bytes() == content.length) {
            try (InputStream in = store.open(key)) {
                if (ByteBuffer.wrap(in.readAllBytes()).equals(ByteBuffer.wrap(content))) return there.get();
            }
        }
        return store.put(Upload.of(key, ObjectContent.of(content)).withHeaders(type, cache));
    }

    private static String hash(byte[] archive) {
        try {
            return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(archive));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }
}
