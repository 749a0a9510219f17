package org.jsmesh.app.paper;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.server.ServerConnector;
import org.eclipse.jetty.server.handler.ResourceHandler;
import org.eclipse.jetty.util.resource.ResourceFactory;
import org.jsmesh.app.server.AccessLog;
import org.jsmesh.app.server.JsmServer;
import org.jsmesh.app.server.ServerSettings;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.sandbox.ModelFilesEncoder;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;

/**
 * The two servers of the experiments: that of jSM with its servlet, as {@code jsm serve} has it, for archives in the
 * folder {@code archives}, and a plain one for what is in the folder {@code text}. Both are in one folder, which gets a
 * log of the requests to the first.
 */
final class PaperServer implements AutoCloseable {
    static final String ARCHIVES = "archives";
    static final String TEXT = "text";
    static final String LOG = "requests.log";

    private final Deque<AutoCloseable> opened = new ArrayDeque<>(); // the last one first
    private final Server text = new Server();
    private final ServerConnector connector = new ServerConnector(text);
    private JsmServer archives;

    private PaperServer() {}

    private void open(Path folder, String host) throws Exception {
        StoreSettings settings =
                StoreSettings.of(folder.resolve(ARCHIVES)).withCache(Files.createDirectories(folder.resolve("cache")));
        ModelStore store = new ModelStore(settings, new ModelFilesEncoder(EncoderSettings.defaults()));
        opened.push(store);
        AccessLog log = AccessLog.to(folder.resolve(LOG));
        opened.push(log);
        ServerSettings defaults = ServerSettings.defaults();
        archives = JsmServer.start(
                defaults.withAddress(host, 0).withLimits(defaults.limits().withRequestRate(0, 1)), store, log);
        opened.push(archives);
        connector.setHost(host);
        text.addConnector(connector);
        ResourceHandler files = new ResourceHandler();
        files.setBaseResource(ResourceFactory.of(files).newResource(folder.resolve(TEXT)));
        text.setHandler(files);
        opened.push(text::stop);
        text.start();
    }

    /** Serves at an address of this machine, each server at a free port. */
    static PaperServer start(Path folder, String host) throws IOException {
        PaperServer server = new PaperServer();
        try {
            server.open(folder, host);
            return server;
        } catch (Exception e) {
            try {
                server.close();
            } catch (IllegalStateException unstopped) {
                e.addSuppressed(unstopped);
            }
            throw e instanceof IOException io ? io : new IOException(e.getMessage(), e);
        }
    }

    /** Address of the server of archives. */
    URI archives() {
        return archives.uri();
    }

    /** Address of the server of text. */
    URI text() {
        return URI.create("http://" + connector.getHost() + ":" + connector.getLocalPort() + "/");
    }

    /** Closes all that was opened, also when some of it cannot be stopped. */
    @Override
    public void close() {
        IllegalStateException failure = null;
        while (!opened.isEmpty()) {
            try {
                opened.pop().close();
            } catch (Exception e) {
                if (failure == null) failure = new IllegalStateException("a server cannot be stopped", e);
                else failure.addSuppressed(e);
            }
        }
        if (failure != null) throw failure;
    }

    /**
     * Serves a folder from a process of its own, prints the two addresses, and ends with its input. Arguments: the
     * folder, the address to listen at.
     */
    public static void main(String[] arguments) throws IOException {
        try (PaperServer server = start(Path.of(arguments[0]), arguments[1])) {
            System.out.println(server.archives());
            System.out.println(server.text());
            System.out.flush();
            while (System.in.read() >= 0) {
                // whoever started it goes on
            }
        }
    }
}
