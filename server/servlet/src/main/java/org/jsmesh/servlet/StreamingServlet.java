package org.jsmesh.servlet;

import jakarta.servlet.ServletContext;
import jakarta.servlet.ServletException;
import jakarta.servlet.ServletRegistration;
import jakarta.servlet.http.HttpServlet;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import jakarta.servlet.http.MappingMatch;
import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.Path;
import java.util.Locale;
import org.jsmesh.secret.SignKeys;
import org.jsmesh.servlet.http.Answer;
import org.jsmesh.servlet.http.PlainPath;
import org.jsmesh.servlet.http.ResponseSender;
import org.jsmesh.store.ModelSource;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;

/**
 * The resources of the protocol: catalogue, manifest, archive, batches and patches, under any path of a web application
 * whose other pages stay what they are. Every address that it sends is relative, so that it need not know its own. Ids
 * are looked up in the store and never become paths. A request for a model that is still being encoded waits a moment
 * without holding a thread, then hears how far that is. {@code docs/protocol.md} describes all.
 *
 * <p>{@link #mount} puts it into a web application. Embedded Jetty 12.1:
 *
 * <pre>{@code
 * StreamingServlet models = new StreamingServlet(Path.of("/srv/models"));
 * Server server = new Server(8080);
 * ServletContextHandler context = new ServletContextHandler("/");
 * context.addServletContainerInitializer((classes, application) -> models.mount(application, "/models/*"));
 * server.setHandler(context);
 * server.start();
 * }</pre>
 *
 * <p>Embedded Tomcat 11:
 *
 * <pre>{@code
 * StreamingServlet models = new StreamingServlet(Path.of("/srv/models"));
 * Tomcat tomcat = new Tomcat();
 * tomcat.setPort(8080);
 * tomcat.getConnector();
 * Context context = tomcat.addContext("", null);
 * context.addServletContainerInitializer((classes, application) -> models.mount(application, "/models/*"), null);
 * tomcat.start();
 * }</pre>
 *
 * <p>Spring Boot 4:
 *
 * <pre>{@code
 * @Bean
 * ServletContextInitializer models() {
 *     return application -> new StreamingServlet(Path.of("/srv/models")).mount(application, "/models/*");
 * }
 * }</pre>
 *
 * The catalogue is then at {@code /models/index.json}. A host may also register the servlet by its own means
 * ({@code ServletHolder}, {@code ServletRegistrationBean}), with support of asynchronous requests and best with an
 * initialization at start. Filters in front of it must support asynchronous requests, too. Thread-safe.
 */
public final class StreamingServlet extends HttpServlet {
    private static final long serialVersionUID = 1L;
    private static final Logger LOG = System.getLogger(StreamingServlet.class.getName());

    /** Nothing here is a page. */
    private static final String POLICY = "default-src 'none'; frame-ancestors 'none'";

    private final transient StoreLease lease;
    private final transient ServletSettings settings;
    private final transient CrossOrigin crossOrigin;
    private transient Models models;
    private transient CatalogueRequests catalogue;
    private transient ModelRequests requests;
    private transient ModelPages pages;
    private transient UploadRequests uploads;
    private final transient SignedAddresses signed;
    private final transient LaunchRequests launches;

    /**
     * Serves the models of a folder, or one model, to pages from anywhere. They are encoded when somebody first asks,
     * and kept in the user's cache folder. What that takes is opened when the container starts the servlet, and closed
     * when it stops it.
     *
     * @param models a folder of model files and archives, or one such file
     * @throws IllegalStateException when the container is older than Servlet 6.1, as by every constructor
     */
    public StreamingServlet(Path models) {
        this(StoreLease.own(() -> StoreSettings.of(models), models), ServletSettings.defaults());
    }

    /**
     * Makes a servlet with settings, for instance with another cache folder:
     * {@code StoreSettings.of(models).withCache(folder)}.
     *
     * @param models where models are, and what is kept of them
     * @param settings how the servlet answers
     */
    public StreamingServlet(StoreSettings models, ServletSettings settings) {
        this(StoreLease.own(() -> models, models.source()), settings);
    }

    /**
     * Makes a servlet over a store.
     *
     * @param store which the caller closes
     * @param settings how it answers
     */
    public StreamingServlet(ModelStore store, ServletSettings settings) {
        this(StoreLease.of(store), settings);
    }

    /**
     * Makes a servlet over models from anywhere, such as a site in a bucket:
     * {@code SiteStore.open(ObjectStores.open("s3://bucket/prefix", SiteStore.PATIENCE), SiteSettings.defaults())}.
     *
     * @param models a {@link ModelStore} or a {@link org.jsmesh.store.bucket.SiteStore}, which the caller closes
     * @param settings how it answers
     */
    public StreamingServlet(ModelSource models, ServletSettings settings) {
        this(StoreLease.of(models), settings);
    }

    private StreamingServlet(StoreLease lease, ServletSettings settings) {
        ServletVersion.require();
        this.lease = lease;
        this.settings = settings;
        crossOrigin = new CrossOrigin(settings.origins(), settings.senders());
        signed = new SignedAddresses(settings.signKeys());
        launches = new LaunchRequests(settings);
    }

    /**
     * Registers the servlet with a web application that is being initialized. It is started with the application, not
     * by the first request.
     *
     * @param application the web application
     * @param pattern {@code /models/*} for what is below a path, {@code /} for everything that nothing else answers
     * @throws IllegalArgumentException when the pattern is no other than these
     * @throws IllegalStateException when the pattern is another servlet's
     */
    public void mount(ServletContext application, String pattern) {
        if (!pattern.equals("/") && !(pattern.startsWith("/") && pattern.endsWith("/*"))) {
            throw new IllegalArgumentException(
                    "'" + pattern + "' is no place for models: give a pattern such as /models/*, or /");
        }
        ServletRegistration.Dynamic registration = application.addServlet("jsm " + pattern, this);
        if (registration == null) {
            throw new IllegalStateException("models are mounted at " + pattern + " already: choose another place");
        }
        registration.setAsyncSupported(true);
        registration.setLoadOnStartup(1);
        if (!registration.addMapping(pattern).isEmpty()) {
            throw new IllegalStateException(pattern + " is another servlet's: choose another place");
        }
    }

    @Override
    public void init() throws ServletException {
        ModelSource source = lease.open();
        models = Models.of(source);
        Waits waits = new Waits();
        catalogue = new CatalogueRequests(models, waits);
        requests = new ModelRequests(waits, launches);
        pages = new ModelPages(settings, waits);
        uploads = new UploadRequests(source instanceof ModelStore store ? store : null, signed);
    }

    @Override
    public void destroy() {
        lease.close();
    }

    @Override
    protected void service(HttpServletRequest request, HttpServletResponse response) throws IOException {
        ResponseSender.check(request);
        try {
            guard(request, response);
            crossOrigin.allow(request, response);
            if (!PlainPath.check(request, response)) return;
            if (uploads.isResumable(path(request))) {
                crossOrigin.allowSending(request, response, TusRequests.METHODS);
                uploads.resume(request, response, path(request));
                return;
            }
            switch (request.getMethod()) {
                case "GET", "HEAD" -> route(request, response);
                case "OPTIONS" -> options(request, response);
                case "POST", "DELETE" -> change(request, response);
                default -> Answer.methodNotAllowed(request, response);
            }
        } catch (IOException | RuntimeException e) {
            if (response.isCommitted()) throw e;
            LOG.log(Level.ERROR, "Cannot answer " + request.getRequestURI(), e);
            int status = HttpServletResponse.SC_INTERNAL_SERVER_ERROR;
            Answer.error(request, response, status, "the server failed to answer", "see the server's log");
        }
    }

    private static void guard(HttpServletRequest request, HttpServletResponse response) {
        response.setHeader("X-Content-Type-Options", "nosniff");
        response.setHeader("Referrer-Policy", "no-referrer");
        response.setHeader("Content-Security-Policy", POLICY);
        if (!request.isAsyncSupported()) {
            throw new IllegalStateException(
                    "the servlet " + request.getHttpServletMapping().getServletName()
                            + " or a filter in front of it is registered without support of asynchronous requests: "
                            + "call setAsyncSupported(true)");
        }
    }

    /** What of the path is the servlet's own; null when the slash behind its folder is missing. */
    private static String path(HttpServletRequest request) {
        String path = request.getPathInfo();
        boolean isDefault = path == null && request.getHttpServletMapping().getMappingMatch() == MappingMatch.DEFAULT;
        return isDefault ? request.getServletPath() : path;
    }

    private void route(HttpServletRequest request, HttpServletResponse response) throws IOException {
        String path = path(request);
        if (path == null) {
            String folder = request.getServletPath();
            Answer.redirect(response, 308, folder.substring(folder.lastIndexOf('/') + 1) + "/");
        } else if (path.equals("/")) {
            catalogue(request, response);
        } else if (CatalogueRequests.isPage(path)) {
            sendCatalogue(request, response, path.substring(1));
        } else if (LaunchRequests.isJar(path)) {
            launches.sendJar(request, response, path);
        } else {
            ResourcePath resource = ResourcePath.parse(path);
            // Whoever may not know of a model does not learn whether there is one.
            if (!signed.admit(request, response, resource == null ? SignKeys.ALL : resource.id())) return;
            if (resource != null && resource.kind() == ResourcePath.Kind.STATUS && uploads.isOn()) {
                uploads.status(request, response, resource.id());
                return;
            }
            AskedModel model = resource == null ? null : models.find(resource.id());
            if (model != null && pages.isAsked(request, response, resource))
                pages.serve(request, response, resource, model);
            else if (model != null && resource.isOfModel()) requests.serve(request, response, resource, model);
            else CatalogueRequests.notFound(request, response);
        }
    }

    /** Pages learn here whether they may offer to send models. */
    private void options(HttpServletRequest request, HttpServletResponse response) {
        crossOrigin.preflight(response, Answer.METHODS);
        if (!uploads.isOn()) return;
        response.setHeader("Allow", Answer.METHODS + ", POST, DELETE");
        crossOrigin.allowSending(request, response, Answer.METHODS + ", POST, DELETE");
    }

    private void change(HttpServletRequest request, HttpServletResponse response) throws IOException {
        crossOrigin.allowSending(request, response, Answer.METHODS + ", POST, DELETE");
        String path = path(request);
        ResourcePath resource = path == null || path.equals("/") ? null : ResourcePath.parse(path);
        boolean isModel = resource != null && resource.kind() == ResourcePath.Kind.MODEL;
        if (!isModel || !uploads.isOn()) Answer.methodNotAllowed(request, response);
        else if (request.getMethod().equals("POST")) uploads.receive(request, response, resource.id());
        else uploads.delete(request, response, resource.id());
    }

    private void catalogue(HttpServletRequest request, HttpServletResponse response) throws IOException {
        String page = settings.page();
        if (page != null) response.addHeader("Vary", "Accept");
        if (page != null && wantsPage(request.getHeader("Accept"))) {
            response.setHeader("Cache-Control", "no-cache");
            Answer.redirect(response, HttpServletResponse.SC_SEE_OTHER, signed.page(request, page));
        } else {
            sendCatalogue(request, response, CatalogueRequests.FIRST);
        }
    }

    private void sendCatalogue(HttpServletRequest request, HttpServletResponse response, String name)
            throws IOException {
        if (!signed.admit(request, response, SignKeys.ALL)) return;
        catalogue.send(request, response, name);
    }

    private static boolean wantsPage(String accept) {
        String types = accept == null ? "" : accept.toLowerCase(Locale.ROOT);
        return types.contains("text/html") && !types.contains("application/json");
    }
}
