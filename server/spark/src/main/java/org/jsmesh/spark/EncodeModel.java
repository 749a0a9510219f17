package org.jsmesh.spark;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.NoSuchFileException;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.stream.Collectors;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.files.ModelEncoding;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.objects.ObjectConflictException;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;
import org.jsmesh.site.ModelPublisher;
import org.jsmesh.store.ids.ModelPath;

/** Reads a model from its store, encodes it and publishes the archive. */
final class EncodeModel implements ModelWork {
    private static final long serialVersionUID = 1;
    private static final int MOST_READS = 3;
    private static final ObjectMapper JSON = new ObjectMapper();

    private final CatalogueSettings settings;
    private final Row.Stamp stamp;
    private final byte[] page;

    /** @param page {@code index.html} of the site */
    EncodeModel(CatalogueSettings settings, Row.Stamp stamp, byte[] page) {
        this.settings = settings;
        this.stamp = stamp;
        this.page = page;
    }

    private record Content(ListedModel file, byte[] bytes) {}

    @Override
    public Row encode(PlannedModel model, int threads, ProgressListener progress) throws IOException {
        long begin = System.nanoTime();
        ListedModel file = model.file();
        ObjectStore store = Worker.store(file.store());
        Companions companions = new Companions(store, file.folder());
        String annotations = "";
        EncodedArchive archive;
        byte[] written = null;
        try {
            Content content = read(store, file);
            file = content.file();
            Optional<StoredObject> beside = Annotations.find(store, file);
            annotations = beside.map(StoredObject::tag).orElse("");
            if (beside.isPresent()) written = Annotations.read(store, beside.get());
            archive = Listing.isArchive(file.key()) ? whole(content) : encode(content, companions, threads, progress);
        } catch (CancellationException e) {
            throw e;
        } catch (IOException | RuntimeException | StackOverflowError e) {
            return new Row(
                    model.id(),
                    file,
                    stamp,
                    CompanionTag.toJson(companions.asked()),
                    annotations,
                    null,
                    PlanTask.failure(file, e),
                    "",
                    "");
        }
        ModelPublisher publisher = new ModelPublisher(Worker.store(settings.site()), page, settings.publicUrl());
        String entry = publisher
                .publish(model.id(), name(file.fileName()), archive, written)
                .json();
        String sha256 = JSON.readTree(entry).path("archiveSha256").asText();
        BatchIndex index = archive.header().batches();
        Row.Facts facts = new Row.Facts(
                settings.site() + "/m/" + model.id() + "/" + sha256 + ".jsm",
                sha256,
                archive.header().faces(),
                archive.header().vertices(),
                index.faces(0),
                index.archiveBytes(),
                index.size(),
                (System.nanoTime() - begin) / 1e9);
        String notes = archive.notes().stream()
                .map(note -> (note.warning() ? "warning: " : "") + note.text())
                .collect(Collectors.joining("\n"));
        return new Row(
                model.id(),
                file,
                stamp,
                CompanionTag.toJson(companions.asked()),
                annotations,
                facts,
                null,
                notes,
                entry);
    }

    /** For people: as the command names models of sites. */
    private static String name(String fileName) {
        int dot = fileName.lastIndexOf('.');
        return dot <= 0 ? ModelPath.stem(fileName) : fileName.substring(0, dot);
    }

    /** One version of the file as a whole: that which was listed, or what it has become. */
    private static Content read(ObjectStore store, ListedModel file) throws IOException {
        ListedModel version = file;
        for (int i = 1; ; i++) {
            if (version.bytes() > Integer.MAX_VALUE - 8)
                throw new IllegalArgumentException("the file is larger than 2 GiB. Cut the model into parts");
            byte[] content = new byte[(int) version.bytes()];
            try {
                store.read(version.version(), 0, ByteBuffer.wrap(content));
                return new Content(version, content);
            } catch (ObjectConflictException e) {
                if (i == MOST_READS) throw e;
                StoredObject now = Listing.find(file);
                if (now == null) throw new NoSuchFileException(file.input());
                version = file.at(now);
            }
        }
    }

    private EncodedArchive encode(Content content, Companions companions, int threads, ProgressListener progress)
            throws IOException {
        ModelEncoding encoding = new ModelEncoding(settings.encoder().withThreads(threads));
        return encoding.encode(content.file().fileName(), content.bytes(), companions, progress);
    }

    private static EncodedArchive whole(Content content) throws MalformedStreamException {
        ArchiveFile archive = ArchiveFile.of(content.bytes());
        if (!archive.isWhole())
            throw new MalformedStreamException(content.bytes().length, "the file ends before the archive does");
        return new EncodedArchive(List.of(ByteBuffer.wrap(content.bytes())), archive.header(), List.of());
    }
}
