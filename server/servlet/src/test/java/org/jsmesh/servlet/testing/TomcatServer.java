package org.jsmesh.servlet.testing;

import jakarta.servlet.ServletContext;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.function.Consumer;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.stream.Stream;
import org.apache.catalina.Context;
import org.apache.catalina.startup.Tomcat;

/** An embedded Tomcat. */
public final class TomcatServer implements TestServer {
    /** Held, because loggers that nobody holds forget their level. */
    private static final Logger LOG = Logger.getLogger("org.apache");

    private final Tomcat tomcat = new Tomcat();
    private final Path base;

    /** @param application puts in what the application has */
    public TomcatServer(Consumer<ServletContext> application) throws Exception {
        LOG.setLevel(Level.SEVERE);
        base = Files.createTempDirectory("jsm-tomcat");
        tomcat.setBaseDir(base.toString());
        tomcat.setHostname("127.0.0.1");
        tomcat.setPort(0);
        tomcat.getConnector().setProperty("address", "127.0.0.1");
        tomcat.getConnector().setProperty("maxThreads", Integer.toString(THREADS));
        Context context = tomcat.addContext("", base.toString());
        context.addServletContainerInitializer((classes, started) -> application.accept(started), null);
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
        try (Stream<Path> left = Files.walk(base)) {
            for (Path file : left.sorted(Comparator.reverseOrder()).toList()) Files.delete(file);
        }
    }
}
