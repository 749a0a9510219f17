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
import org.jsmesh.mesh.Sizes;
import org.jsmesh.objects.ObjectConflictException;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;
import org.jsmesh.site.ModelPublisher;
import org.jsmesh.store.ids.ModelPath;

/** Reads a model from its store, encodes it and publishes the archive. */
final class EncodeModel implements ModelWork {
    private static final long serialVersionUID = 1;

    /** Files up to here are read into memory, of larger ones a small part at a time. */
    private static final long LARGE = 16L << 20;

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

    /** {@return what of a file is in memory while it is encoded, beside what the estimate counts} */
    static long heldBytes(ListedModel file) {
        return file.bytes() <= LARGE ? file.bytes() : 0;
    }

    @Override
    public Row encode(PlannedModel model, int threads, ProgressListener progress)
            throws IOException, ModelChangedException {
        long begin = System.nanoTime();
        ListedModel file = model.file();
        ObjectStore store = Worker.store(file.store());
        Companions companions = new Companions(store, file.folder());
        String annotations = "";
        EncodedArchive archive;
        byte[] written = null;
        try {
            Optional<StoredObject> beside = Annotations.find(store, file);
            annotations = beside.map(StoredObject::tag).orElse("");
            if (beside.isPresent()) written = Annotations.read(store, beside.get());
            archive = Listing.isArchive(file.key())
                    ? whole(file, content(store, file))
                    : encode(store, file, companions, threads, progress);
        } catch (CancellationException e) {
            throw e;
        } catch (IOException | RuntimeException | StackOverflowError e) {
            // What an interrupted thread could not read is not the model's fault.
            if (progress.isCancelled() || Thread.currentThread().isInterrupted()) throw e;
            if (e instanceof ObjectConflictException conflict) {
                PlanRow now = replan(model, conflict);
                if (now != null) return now.row();
            }
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

    /** The row of a model that has become one that cannot be encoded; null when it is the same as it was. */
    private PlanRow replan(PlannedModel model, ObjectConflictException conflict)
            throws IOException, ModelChangedException {
        StoredObject found;
        PlanRow row;
        try {
            found = Listing.find(model.file());
            if (found == null) throw new NoSuchFileException(model.file().input());
            // It was a companion, or the annotations, that changed.
            if (found.equals(model.file().version())) return null;
            row = new PlanTask(settings, stamp).plan(model.id(), model.file().at(found));
        } catch (IOException | RuntimeException e) {
            Row.Failure failure = PlanTask.failure(model.file(), e);
            return new PlanRow(
                    PlanRow.Kind.REFUSED,
                    null,
                    new Row(model.id(), model.file(), stamp, "", "", null, failure, "", ""));
        }
        if (row.is(PlanRow.Kind.ENCODE)) throw new ModelChangedException(row.planned(), conflict);
        return row;
    }

    private static byte[] content(ObjectStore store, ListedModel file) throws IOException {
        if (file.bytes() > Sizes.MOST)
            throw new IllegalArgumentException(
                    "the archive is larger than 2 GiB. Publish it by 'jsm encode --site' on one machine");
        byte[] content = new byte[(int) file.bytes()];
        store.read(file.version(), 0, ByteBuffer.wrap(content));
        return content;
    }

    private EncodedArchive encode(
            ObjectStore store, ListedModel file, Companions companions, int threads, ProgressListener progress)
            throws IOException {
        ModelEncoding encoding = new ModelEncoding(settings.encoder().withThreads(threads));
        return heldBytes(file) > 0
                ? encoding.encode(file.fileName(), content(store, file), companions, progress)
                : encoding.encode(file.fileName(), new StoreSource(store, file.version()), companions, progress);
    }

    private static EncodedArchive whole(ListedModel file, byte[] content) throws MalformedStreamException {
        ArchiveFile archive = ArchiveFile.of(content);
        if (!archive.isWhole())
            throw new MalformedStreamException(file.bytes(), "the file ends before the archive does");
        return new EncodedArchive(List.of(ByteBuffer.wrap(content)), archive.header(), List.of());
    }
}
