package org.jsmesh.servlet;

import java.nio.file.Path;
import java.util.concurrent.Callable;
import java.util.function.UnaryOperator;
import java.util.logging.Level;
import java.util.logging.Logger;
import org.apache.catalina.Context;
import org.apache.catalina.startup.Tomcat;
import org.apache.catalina.util.ServerInfo;
import org.apache.catalina.webresources.TomcatURLStreamHandlerFactory;

/**
 * A host on the Tomcat of its own class loader, which {@link OldContainerTest} makes. It speaks with the test in types
 * of the JDK alone: its other types are not the test's.
 */
public final class OldContainerHost implements UnaryOperator<Path>, Callable<String> {
    private static final Logger LOG = Logger.getLogger("org.apache");

    /** Name and number of the Tomcat. */
    @Override
    public String call() {
        return ServerInfo.getServerInfo();
    }

    /**
     * Starts it with models that are mounted, and stops it.
     *
     * @return the models
     * @throws IllegalStateException when it does not start
     */
    @Override
    public Path apply(Path models) {
        LOG.setLevel(Level.OFF);
        // The process takes one of them, and has that of the other Tomcat.
        TomcatURLStreamHandlerFactory.disable();
        Tomcat tomcat = new Tomcat();
        tomcat.setBaseDir(models.resolve("tomcat").toString());
        tomcat.setHostname("127.0.0.1");
        tomcat.setPort(0);
        tomcat.getConnector().setProperty("address", "127.0.0.1");
        Context context = tomcat.addContext("", models.toString());
        context.addServletContainerInitializer(
                (classes, application) -> new StreamingServlet(models).mount(application, "/models/*"), null);
        try {
            tomcat.start();
            return models;
        } catch (Exception e) {
            throw new IllegalStateException(e);
        } finally {
            stop(tomcat);
        }
    }

    private static void stop(Tomcat tomcat) {
        try {
            tomcat.stop();
            tomcat.destroy();
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
    }
}
