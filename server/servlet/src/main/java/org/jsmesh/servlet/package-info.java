/**
 * The HTTP resources of the streaming protocol, under a path that the host chooses, for any container of Jakarta
 * Servlet 6.1. {@code application} is a {@code ServletContext} that is being initialized:
 *
 * <pre>{@code
 * StoreSettings store = StoreSettings.of(Path.of("/srv/models")).withCache(Path.of("/var/cache/jsm"));
 * ServletSettings settings = ServletSettings.defaults().withOrigins(List.of("https://example.org"));
 * new StreamingServlet(store, settings).mount(application, "/models/*");
 * }</pre>
 */
package org.jsmesh.servlet;
