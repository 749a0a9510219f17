package org.jsmesh.servlet;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import org.jsmesh.files.ArchiveParts;
import org.jsmesh.servlet.http.Answer;
import org.jsmesh.servlet.http.Document;
import org.jsmesh.store.ArchiveFacts;
import org.jsmesh.store.ModelEntry;
import org.jsmesh.store.ModelPage;
import org.jsmesh.store.ModelStatus;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.ids.ModelIds;

/**
 * The list of models as JSON, in pages that are kept as they were sent and made anew when a model of theirs has
 * changed; {@code docs/protocol.md} describes their members. Thread-safe.
 */
final class Catalogue {
    /** How old the progress of an encoding may be. */
    private static final long PROGRESS_NANOS = 1_000_000_000L;
    /** Most pages that are kept. */
    private static final int MOST_KEPT = 256;

    private static final String TYPE = "application/json";
    private static final int ROW_BYTES = 800;

    private final ModelStore store;
    private final Map<String, Kept> kept = new LinkedHashMap<>(64, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Kept> eldest) {
            return size() > MOST_KEPT;
        }
    };

    Catalogue(ModelStore store) {
        this.store = store;
    }

    /** A page with what it was made from. */
    private static final class Kept {
        private long version = -1;
        private String next;
        private long shape;
        private boolean showsProgress;
        private long madeNanos;
        private Document document;

        /** One request makes it for all that ask for it. */
        synchronized Document of(ModelPage page) throws IOException {
            boolean isSame = version == page.version()
                    && Objects.equals(next, page.next())
                    && (shape == page.shape() || page.after() != null);
            boolean isOld = showsProgress && System.nanoTime() - madeNanos > PROGRESS_NANOS;
            if (isSame && !isOld) return document;
            madeNanos = System.nanoTime();
            List<ModelStatus> models = page.models();
            document = Document.compact(TYPE, json(page, models));
            showsProgress = models.stream().anyMatch(m -> m.state() == ModelStatus.State.PREPARING);
            version = page.version();
            next = page.next();
            shape = page.shape();
            return document;
        }
    }

    /** The models behind an id; the first ones for null. */
    Document page(String after) throws IOException {
        ModelPage page = store.page(after);
        // Anybody can make up an id that pages do not name; such a page is not worth keeping.
        if (!page.isWhole()) return Document.of(TYPE, json(page, page.models()));
        Kept of;
        synchronized (kept) {
            of = kept.computeIfAbsent(after == null ? "" : after, id -> new Kept());
        }
        return of.of(page);
    }

    private static byte[] json(ModelPage page, List<ModelStatus> models) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream(64 + ROW_BYTES * models.size());
        try (JsonGenerator json = Answer.JSON.createGenerator(out)) {
            json.writeStartObject();
            if (page.after() == null) json.writeNumberField("total", page.total());
            if (page.next() != null) json.writeStringField("next", ModelPage.fileName(ModelIds.segment(page.next())));
            if (page.next() != null && page.after() == null) parts(page.parts(), json);
            json.writeArrayFieldStart("models");
            for (ModelStatus model : models) row(model, json);
            json.writeEndArray();
            json.writeEndObject();
        }
        return out.toByteArray();
    }

    /** The index by which a page is found without reading those before it. */
    private static void parts(List<ModelPage.Part> parts, JsonGenerator json) throws IOException {
        json.writeArrayFieldStart("pages");
        for (ModelPage.Part part : parts) {
            if (part.after() == null) continue; // the first page itself
            json.writeStartArray();
            json.writeString(part.first());
            json.writeNumber(part.models());
            json.writeString(ModelPage.fileName(ModelIds.segment(part.after())));
            json.writeEndArray();
        }
        json.writeEndArray();
    }

    private static void row(ModelStatus model, JsonGenerator json) throws IOException {
        ModelEntry entry = model.entry();
        String segment = entry.segment();
        json.writeStartObject();
        json.writeStringField("id", entry.id());
        json.writeStringField("name", entry.name());
        json.writeStringField("format", entry.format());
        json.writeNumberField("fileBytes", entry.bytes());
        json.writeStringField("modified", entry.modified().toString());
        json.writeStringField("manifestUrl", segment + "/manifest.json");
        json.writeStringField("state", model.state().name().toLowerCase(Locale.ROOT));
        switch (model.state()) {
            case READY -> archive(segment, model.facts(), json);
            case PREPARING -> {
                json.writeStringField("stage", model.stage());
                json.writeNumberField("fraction", model.fraction());
            }
            case FAILED -> {
                json.writeStringField("error", model.failure().getMessage());
                json.writeStringField("remedy", model.failure().remedy());
            }
            default -> {
                // Nothing is known of a model that nobody has asked for.
            }
        }
        json.writeEndObject();
    }

    private static void archive(String folder, ArchiveFacts facts, JsonGenerator json) throws IOException {
        String archiveUrl = folder + "/" + facts.sha256() + ".jsm";
        json.writeStringField("archiveUrl", archiveUrl);
        json.writeStringField("archiveSha256", facts.sha256());
        if (facts.hasPoster()) json.writeStringField("posterUrl", ArchiveParts.url(archiveUrl, ArchiveParts.POSTER));
        json.writeStringField("meshSha256", facts.meshSha256());
        json.writeNumberField("bytes", facts.bytes());
        json.writeNumberField("faces", facts.faces());
        json.writeNumberField("vertices", facts.vertices());
        json.writeNumberField("baseFaces", facts.baseFaces());
        json.writeNumberField("baseBytes", facts.baseBytes());
        json.writeNumberField("materials", facts.materials());
        json.writeNumberField("textures", facts.textures());
        json.writeArrayFieldStart("bounds");
        for (Number bound : facts.bounds()) {
            if (bound instanceof Float) json.writeNumber(bound.floatValue());
            else json.writeNumber(bound.doubleValue());
        }
        json.writeEndArray();
    }
}
