package org.jsmesh.site;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.security.DigestOutputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.temporal.ChronoUnit;
import java.util.HexFormat;
import java.util.List;
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
 * write different models at once, on different machines. Objects that are there already are left alone, unless they are
 * so old that another run may be removing them. Thread-safe.
 */
public final class ModelPublisher {
    private final ObjectStore store;
    private final PageTemplate template;
    private final String publicUrl;
    private final boolean isAlone;

    /**
     * Writes to a site.
     *
     * @param store of the site
     * @param page {@code index.html} of the site's page, with its files' names
     * @param publicUrl address of the site, which ends with a slash; null when it is not known
     */
    public ModelPublisher(ObjectStore store, byte[] page, String publicUrl) {
        this(store, page, publicUrl, false);
    }

    /** @param isAlone whether nobody else writes to the site meanwhile */
    ModelPublisher(ObjectStore store, byte[] page, String publicUrl, boolean isAlone) {
        this.store = store;
        this.isAlone = isAlone;
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
        ObjectContent content = content(archive);
        Source source = (offset, length) -> copy(archive, offset, length);
        return publish(id, name, content, hash(archive), archive.header(), annotations, source);
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
        String manifest = ArchiveReport.of(header, hash)
                .toManifestJson(id, name, hash + ".jsm", annotations == null ? null : AnnotationFile.NAME);
        Work work = new Work(id, hash, archive, header.batches(), annotations, source, manifest);
        KnownManifest before = KnownManifest.read(store, id);
        StoredObject written = write(work, before);
        // Another run may have been removing the model, of which it did not know that it comes back.
        if (!isAlone && before.isOld() && !isThere(work)) written = write(work, KnownManifest.read(store, id));
        return CatalogueJson.row(
                id, manifest, written.modified().truncatedTo(ChronoUnit.SECONDS).toString());
    }

    /** What is published. */
    private record Work(
            String id,
            String hash,
            ObjectContent archive,
            BatchIndex index,
            byte[] annotations,
            Source source,
            String manifest) {
        String key() {
            return ModelKeys.key(id, hash + ".jsm");
        }

        String part(String name) {
            return ModelKeys.archive(id, hash, name);
        }
    }

    private boolean isThere(Work work) throws IOException {
        for (String key : List.of(work.key(), ModelKeys.manifest(work.id()), ModelKeys.page(work.id())))
            if (store.find(key).isEmpty()) return false;
        return true;
    }

    /** Writes all objects of a model that are not there; the manifest that is there then. */
    private StoredObject write(Work work, KnownManifest before) throws IOException {
        StoredObject there = before.object();
        boolean isCurrent = before.hasArchive(work.hash());
        // A young manifest guards the archive that it names.
        if (isCurrent && before.isOld() && !isAlone) there = putManifest(work.id(), before.content());
        boolean isKept = isCurrent || isAlone;
        put(work.key(), work.archive(), SiteHeaders.ARCHIVE, isKept);
        byte[] poster = putParts(work, isKept);
        String notes = ModelKeys.annotations(work.id());
        if (work.annotations() != null) write(store, notes, work.annotations(), SiteHeaders.JSON, SiteHeaders.CHANGING);
        byte[] manifest = work.manifest().getBytes(StandardCharsets.UTF_8);
        if (!before.is(manifest)) there = putManifest(work.id(), manifest);
        if (work.annotations() == null && before.hasAnnotations()) store.delete(notes);
        writePage(work.id(), work.manifest(), poster);
        return there;
    }

    private StoredObject putManifest(String id, byte[] content) throws IOException {
        return store.put(Upload.of(ModelKeys.manifest(id), ObjectContent.of(content))
                .withHeaders(SiteHeaders.JSON, SiteHeaders.CHANGING));
    }

    /** Writes what a server cuts out of the archive; the poster, or null. */
    private byte[] putParts(Work work, boolean isKept) throws IOException {
        BatchIndex index = work.index();
        byte[] first = work.source().copy(0, index.firstBytes());
        put(work.part(ArchiveParts.FIRST), ObjectContent.of(first), SiteHeaders.ARCHIVE, isKept);
        int poster = index.poster();
        if (poster < 0) return null;
        byte[] jpeg = work.source().copy(index.offset(poster), BatchIndex.payloadBytes(index.bytes(poster)));
        put(work.part(ArchiveParts.POSTER), ObjectContent.of(jpeg), SiteHeaders.JPEG, isKept);
        return jpeg;
    }

    private void writePage(String id, String manifest, byte[] poster) throws IOException {
        write(store, ModelKeys.page(id), page(id, manifest, poster), SiteHeaders.HTML, SiteHeaders.CHANGING);
    }

    /** What the page of a model is to be. */
    byte[] page(String id, String manifest, byte[] poster) {
        return template.page(ModelIds.segment(id), manifest, poster, publicUrl).getBytes(StandardCharsets.UTF_8);
    }

    /**
     * Writes an object that is named after its content.
     *
     * @param isKept whether nobody removes it when it is there; what others may remove is written again
     */
    private void put(String key, ObjectContent content, String type, boolean isKept) throws IOException {
        StoredObject there = store.find(key).orElse(null);
        boolean isWhole = there != null && there.bytes() == content.bytes();
        if (isWhole && (isKept || !KnownManifest.isOld(there))) return;
        store.put(Upload.of(key, content).withHeaders(type, SiteHeaders.FOR_EVER));
    }

    /** The content of an object; null when it is not there. */
    static byte[] read(ObjectStore store, String key) throws IOException {
        try (InputStream in = store.open(key)) {
            return in.readAllBytes();
        } catch (NoSuchFileException e) {
            return null;
        }
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

    private static ObjectContent content(EncodedArchive archive) {
        return new ObjectContent() {
            @Override
            public long bytes() {
                return archive.length();
            }

            @Override
            public InputStream open() {
                return archive.open();
            }
        };
    }

    private static byte[] copy(EncodedArchive archive, long offset, int length) throws IOException {
        try (InputStream in = archive.open()) {
            in.skipNBytes(offset);
            return in.readNBytes(length);
        }
    }

    private static String hash(EncodedArchive archive) throws IOException {
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            archive.writeTo(new DigestOutputStream(OutputStream.nullOutputStream(), digest));
            return HexFormat.of().formatHex(digest.digest());
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }
}
