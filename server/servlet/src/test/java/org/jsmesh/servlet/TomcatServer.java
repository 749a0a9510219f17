package org.jsmesh.servlet;

import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.logging.Level;
import java.util.logging.Logger;
import org.apache.catalina.Context;
import org.apache.catalina.startup.Tomcat;
import org.jsmesh.store.ModelStore;

/** The application in an embedded Tomcat. */
final class TomcatServer implements TestServer {
    /** Held, because loggers that nobody holds forget their level. */
    private static final Logger LOG = Logger.getLogger("org.apache");

    private final Tomcat tomcat = new Tomcat();

    TomcatServer(ModelStore store) throws Exception {
        LOG.setLevel(Level.SEVERE);
        Path base = Files.createTempDirectory("jsm-tomcat");
        base.toFile().deleteOnExit();
        tomcat.setBaseDir(base.toString());
        tomcat.setHostname("127.0.0.1");
        tomcat.setPort(0);
        tomcat.getConnector().setProperty("address", "127.0.0.1");
        tomcat.getConnector().setProperty("maxThreads", Integer.toString(THREADS));
        Context context = tomcat.addContext("", base.toString());
        context.addServletContainerInitializer(
                (classes, application) -> {
                    FailingWrites.install(application);
                    StreamingApplication.install(application, store, ServletSettings.defaults());
                },
                null);
        tomcat.start();
    }

    @Override
    public URI root() {
        return URI.create("http://127.0.0.1:" + tomcat.getConnector().getLocalPort() + "/");
    }

    @Override
    public void stop() throws Exception {
        tomcat.stop();
        tomcat.destroy();
    }
}
