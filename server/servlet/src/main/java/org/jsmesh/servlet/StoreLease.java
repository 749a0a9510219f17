package org.jsmesh.servlet;

import jakarta.servlet.ServletException;
import java.io.IOException;
import java.nio.file.Path;
import org.jsmesh.files.Explanation;
import org.jsmesh.sandbox.SandboxEncoder;
import org.jsmesh.sandbox.SandboxLimits;
import org.jsmesh.store.ModelSource;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;

/**
 * The store of a servlet: one that somebody else opens and closes, or one of its own, open from each start of the
 * servlet to its end.
 */
final class StoreLease {
    private final Settings settings;
    private final Path models;
    private ModelSource store;

    /** Settings that cannot be made everywhere. */
    interface Settings {
        StoreSettings get() throws IOException;
    }

    private StoreLease(Settings settings, Path models, ModelSource store) {
        this.settings = settings;
        this.models = models;
        this.store = store;
    }

    static StoreLease own(Settings settings, Path models) {
        return new StoreLease(settings, models, null);
    }

    static StoreLease of(ModelSource store) {
        return new StoreLease(null, null, store);
    }

    /** @throws ServletException that says what is wrong with the models or the cache folder */
    ModelSource open() throws ServletException {
        if (settings == null) return store;
        if (store != null)
            throw new ServletException("the models are served already: make a StreamingServlet for every place");
        try {
            store = new ModelStore(settings.get(), SandboxEncoder.orInProcess(SandboxLimits.defaults()));
            return store;
        } catch (IOException e) {
            throw new ServletException("jSM cannot serve models: " + Explanation.of(models, e), e);
        }
    }

    void close() {
        if (settings == null || store == null) return;
        store.close();
        store = null;
    }
}
