package org.jsmesh.servlet;

import jakarta.servlet.ServletContext;
import java.util.function.Consumer;
import org.jsmesh.store.ModelStore;

/** A web application with the servlet at {@code /m/*}, whose answers can be made to fail. */
final class TestApplication {
    private TestApplication() {}

    static Consumer<ServletContext> of(ModelStore store) {
        return of(store, ServletSettings.defaults());
    }

    static Consumer<ServletContext> of(ModelStore store, ServletSettings settings) {
        return context -> {
            FailingWrites.install(context);
            new StreamingServlet(store, settings.withPage("../")).mount(context, "/m/*");
        };
    }
}
