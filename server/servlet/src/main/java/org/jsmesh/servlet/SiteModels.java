package org.jsmesh.servlet;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.ref.WeakReference;
import java.net.URI;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.regex.Pattern;
import org.jsmesh.servlet.http.Document;
import org.jsmesh.store.ModelUnavailableException;
import org.jsmesh.store.ServedArchive;
import org.jsmesh.store.bucket.SiteModel;
import org.jsmesh.store.bucket.SiteStore;

/** The models of a site in a store of objects. */
final class SiteModels implements Models {
    /** Pages whose names are made of their content. */
    private static final Pattern IMMUTABLE = Pattern.compile("page-[0-9a-f]{16,64}\\.json");

    private static final int MOST_KEPT = 64;

    private final SiteStore site;
    private final Map<String, Kept> kept = new LinkedHashMap<>(64, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Kept> eldest) {
            return size() > MOST_KEPT;
        }
    };

    /** A page as it is sent. One request packs it for all. */
    private static final class Kept {
        private WeakReference<byte[]> json = new WeakReference<>(null);
        private Document document;

        synchronized Document of(byte[] now) {
            if (json.get() == now) return document;
            try {
                document = Document.compact("application/json", now);
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
            json = new WeakReference<>(now);
            return document;
        }
    }

    SiteModels(SiteStore site) {
        this.site = site;
    }

    @Override
    public AskedModel find(String id) {
        return new OfSite(site, id);
    }

    @Override
    public CompletableFuture<CataloguePage> catalogue(String name) {
        boolean isImmutable = IMMUTABLE.matcher(name).matches();
        return site.catalogue(name, isImmutable)
                .thenApply(json -> json == null ? null : new CataloguePage(document(name, json), isImmutable));
    }

    private Document document(String name, byte[] json) {
        Kept page;
        synchronized (kept) {
            page = kept.computeIfAbsent(name, n -> new Kept());
        }
        return page.of(json);
    }

    /** A model of the site, if there is one. */
    private record OfSite(SiteStore site, String id) implements AskedModel {
        @Override
        public CompletableFuture<String> name() {
            return site.model(id).thenApply(SiteModel::name);
        }

        @Override
        public CompletableFuture<byte[]> manifest(String client) {
            return site.model(id).thenApply(SiteModel::manifest);
        }

        @Override
        public CompletableFuture<? extends ServedArchive> archive(String client, String sha256) {
            return site.archive(id, sha256)
                    .thenCompose(archive -> archive == null
                            ? site.model(id).thenApply(model -> {
                                throw new CompletionException(ModelUnavailableException.absent(
                                        "the archive of this model is another one by now: " + model.sha256()));
                            })
                            : CompletableFuture.<ServedArchive>completedFuture(archive));
        }

        @Override
        public ServedArchive recent(String sha256) {
            return site.recent(id, sha256);
        }

        @Override
        public CompletableFuture<Look> look(String client) {
            return site.model(id)
                    .thenCompose(model -> archive(client, model.sha256())
                            .thenCompose(FolderModels::poster)
                            .thenApply(jpeg -> new Look(model.manifest(), jpeg)));
        }

        @Override
        public CompletableFuture<byte[]> annotations() {
            return site.annotations(id);
        }

        @Override
        public URI elsewhere(String sha256) {
            return site.redirect(id, sha256).orElse(null);
        }

        @Override
        public boolean isOpening() {
            return true;
        }

        @Override
        public Progress progress() {
            return new Progress("opening", 0);
        }
    }
}
