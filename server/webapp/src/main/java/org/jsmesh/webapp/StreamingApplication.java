package org.jsmesh.webapp;

import jakarta.servlet.DispatcherType;
import jakarta.servlet.FilterRegistration;
import jakarta.servlet.ServletContext;
import jakarta.servlet.ServletContextEvent;
import jakarta.servlet.ServletContextListener;
import jakarta.servlet.ServletRegistration;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.ObjectStores;
import org.jsmesh.page.PageTemplate;
import org.jsmesh.sandbox.SandboxEncoder;
import org.jsmesh.sandbox.SandboxLimits;
import org.jsmesh.secret.SignKeys;
import org.jsmesh.servlet.ServletSettings;
import org.jsmesh.servlet.StreamingServlet;
import org.jsmesh.servlet.ViewerJar;
import org.jsmesh.store.ModelSource;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;
import org.jsmesh.store.bucket.SiteSettings;
import org.jsmesh.store.bucket.SiteStore;
import org.jsmesh.upload.UploadSettings;
import org.jsmesh.upload.UploadTokens;

/**
 * Puts the servlets and the filter into a web application, the same way in every container. Deployed as a WAR it opens
 * its store itself. {@code jsm.models} names the folder (or file) to serve, or a site as {@code s3://bucket/prefix}
 * where jsm-s3 is on the class path, {@code jsm.cache} the folder for encoded archives, {@code jsm.cors.origins} the
 * origins of pages that may read archives, with commas between them (default: {@code *}), {@code jsm.embed.origins}
 * those of pages that may have its page in a frame, {@code jsm.public.url} the address of the page as visitors have it,
 * with a slash at its end (default: what they ask for), {@code jsm.sign.key} the keys that sign addresses (default:
 * models are for anybody), {@code jsm.viewer.jar} the desktop viewer, signed, that visitors start from the page
 * (default: none), and {@code jsm.upload.token.file} the tokens of those who may send models (default: nobody may). It
 * looks for each as a system property, then as an environment variable (such as {@code JSM_MODELS}), then as a context
 * parameter.
 */
public final class StreamingApplication implements ServletContextListener {
    private static final String PAGE = "jsm-page";

    private ModelSource store;
    private ObjectStore objects; // of a site in a bucket

    /**
     * Adds servlets and filter to a web application that is being initialized.
     *
     * @param store the caller closes it
     */
    public static void install(ServletContext context, ModelSource store, ServletSettings settings) {
        PageFiles files = new PageFiles();
        PageTemplate template = new PageTemplate(PageFiles.firstPage(), SecurityHeaders.ofPages(settings.embedders()));
        new StreamingServlet(store, settings.withPage("../").withTemplate(template)).mount(context, "/m/*");
        ServletRegistration.Dynamic page = context.addServlet(PAGE, new PageServlet(files));
        page.addMapping("/");
        page.setAsyncSupported(true);
        FilterRegistration.Dynamic headers =
                context.addFilter("jsm-headers", new SecurityHeaders(settings.embedders()));
        headers.setAsyncSupported(true);
        headers.addMappingForServletNames(EnumSet.of(DispatcherType.REQUEST), false, PAGE);
    }

    @Override
    public void contextInitialized(ServletContextEvent event) {
        ServletContext context = event.getServletContext();
        boolean isUp = false;
        try {
            store = open(context);
            install(context, store, settings(context));
            isUp = true;
        } catch (IOException e) {
            throw new UncheckedIOException("jSM cannot serve as it is told: check jsm.sign.key and jsm.viewer.jar", e);
        } finally {
            // A container need not tell of the end of what has not begun.
            if (!isUp) close();
        }
    }

    @Override
    public void contextDestroyed(ServletContextEvent event) {
        close();
    }

    private void close() {
        if (store != null) store.close();
        try {
            if (objects != null) objects.close();
        } catch (IOException e) {
            // It was read only: nothing can be lost.
        }
    }

    private ModelSource open(ServletContext context) {
        String models = setting(context, "jsm.models");
        if (models == null) {
            throw new IllegalStateException(
                    "jSM does not know what to serve: set the system property jsm.models, the environment "
                            + "variable JSM_MODELS or the context parameter jsm.models to a folder of models");
        }
        try {
            if (ObjectStores.isRemote(models)) {
                objects = ObjectStores.open(models, SiteStore.PATIENCE);
                return SiteStore.open(objects, SiteSettings.defaults());
            }
            StoreSettings settings = StoreSettings.of(Path.of(models));
            String cache = setting(context, "jsm.cache");
            String tokens = setting(context, "jsm.upload.token.file");
            ModelStore opened = new ModelStore(
                    cache == null ? settings : settings.withCache(Path.of(cache)),
                    SandboxEncoder.orInProcess(SandboxLimits.defaults()));
            if (tokens != null) opened.acceptUploads(UploadSettings.of(UploadTokens.read(Path.of(tokens))));
            return opened;
        } catch (IOException e) {
            throw new UncheckedIOException(
                    "jSM cannot serve " + models + ": check jsm.models, jsm.cache and jsm.upload.token.file", e);
        }
    }

    private static ServletSettings settings(ServletContext context) throws IOException {
        String keys = setting(context, "jsm.sign.key");
        String viewer = setting(context, "jsm.viewer.jar");
        return ServletSettings.defaults()
                .withViewer(viewer == null ? null : ViewerJar.open(Path.of(viewer)))
                .withSignKeys(keys == null ? null : SignKeys.read(Path.of(keys)))
                .withPublicUrl(setting(context, "jsm.public.url"))
                .withSenders(origins(setting(context, "jsm.upload.origins"), List.of()))
                .withOrigins(origins(setting(context, "jsm.cors.origins"), List.of("*")))
                .withEmbedders(origins(setting(context, "jsm.embed.origins"), List.of()));
    }

    private static List<String> origins(String named, List<String> unnamed) {
        return named == null ? unnamed : List.of(named.strip().split("\\s*,\\s*"));
    }

    private static String setting(ServletContext context, String name) {
        String value = System.getProperty(name);
        if (value == null) value = System.getenv(name.toUpperCase(Locale.ROOT).replace('.', '_'));
        if (value == null) value = context.getInitParameter(name);
        return value == null || value.isBlank() ? null : value;
    }
}
