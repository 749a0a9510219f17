package org.jsmesh.servlet;

import jakarta.servlet.ServletContext;
import java.util.Map;
import java.util.function.Consumer;
import org.jsmesh.page.PageTemplate;
import org.jsmesh.store.ModelSource;
import org.jsmesh.store.ModelStore;

/** A web application with the servlet at {@code /m/*}, whose answers can be made to fail. */
final class TestApplication {
    private static final PageTemplate TEMPLATE = new PageTemplate(
            "<html><head><meta charset=\"utf-8\"><title>Models</title><meta name=\"description\" content=\"\">"
                    + "</head><body><noscript></noscript></body></html>",
            Map.of("Content-Security-Policy", "default-src 'self'"));

    private TestApplication() {}

    static Consumer<ServletContext> of(ModelStore store) {
        return of(store, ServletSettings.defaults());
    }

    static Consumer<ServletContext> of(ModelSource store, ServletSettings settings) {
        return context -> {
            FailingWrites.install(context);
            new StreamingServlet(store, settings.withPage("../").withTemplate(TEMPLATE)).mount(context, "/m/*");
        };
    }
}
