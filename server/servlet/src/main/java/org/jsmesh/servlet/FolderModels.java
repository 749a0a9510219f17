package org.jsmesh.servlet;

import java.io.IOException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.files.AnnotationFile;
import org.jsmesh.files.ArchiveReport;
import org.jsmesh.store.ModelEntry;
import org.jsmesh.store.ModelPage;
import org.jsmesh.store.ModelStatus;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.ModelUnavailableException;
import org.jsmesh.store.ServedArchive;

/** The models of a folder. */
final class FolderModels implements Models {
    private final ModelStore store;
    private final Catalogue catalogue;

    FolderModels(ModelStore store) {
        this.store = store;
        catalogue = new Catalogue(store);
    }

    @Override
    public AskedModel find(String id) throws IOException {
        ModelEntry entry = store.find(id).orElse(null);
        return entry == null ? null : new OfFolder(store, entry);
    }

    @Override
    public CompletableFuture<CataloguePage> catalogue(String name) throws IOException {
        String after = ModelPage.after(name);
        boolean isPage = after != null || name.equals("index.json");
        return CompletableFuture.completedFuture(isPage ? new CataloguePage(catalogue.page(after), false) : null);
    }

    /** A model of the folder. */
    private record OfFolder(ModelStore store, ModelEntry entry) implements AskedModel {
        @Override
        public String id() {
            return entry.id();
        }

        @Override
        public CompletableFuture<String> name() {
            return CompletableFuture.completedFuture(entry.name());
        }

        @Override
        public CompletableFuture<byte[]> manifest(String client) throws ModelUnavailableException {
            return store.archive(entry, client).thenApply(this::manifest);
        }

        private byte[] manifest(ServedArchive archive) {
            ArchiveReport report = ArchiveReport.of(archive.header(), archive.sha256());
            // The address of the annotations is relative to the manifest's.
            String annotations = AnnotationFile.beside(entry.path()) == null ? null : AnnotationFile.NAME;
            return report.toManifestJson(entry.id(), entry.name(), archive.sha256() + ".jsm", annotations)
                    .getBytes(StandardCharsets.UTF_8);
        }

        @Override
        public CompletableFuture<? extends ServedArchive> archive(String client, String sha256)
                throws ModelUnavailableException {
            return store.archive(entry, client);
        }

        @Override
        public ServedArchive recent(String sha256) {
            return store.recent(entry);
        }

        @Override
        public CompletableFuture<Look> look(String client) throws ModelUnavailableException {
            return store.archive(entry, client)
                    .thenCompose(archive -> poster(archive).thenApply(jpeg -> new Look(manifest(archive), jpeg)));
        }

        @Override
        public CompletableFuture<byte[]> annotations() throws IOException {
            Path file = AnnotationFile.beside(entry.path());
            return CompletableFuture.completedFuture(file == null ? null : AnnotationFile.read(file));
        }

        @Override
        public URI elsewhere(String sha256) {
            return null;
        }

        @Override
        public boolean isOpening() {
            return store.isOpening(entry);
        }

        @Override
        public Progress progress() {
            ModelStatus status = store.status(entry);
            return new Progress(status.stage() == null ? "waiting" : status.stage(), status.fraction());
        }
    }

    /** The poster in an archive, null in it when it has none. */
    static CompletableFuture<byte[]> poster(ServedArchive archive) {
        BatchIndex index = archive.batches();
        int batch = index.poster();
        if (batch < 0) return CompletableFuture.completedFuture(null);
        return archive.read(index.offset(batch), BatchIndex.payloadBytes(index.bytes(batch)));
    }
}
