package org.jsmesh.webapp;

import jakarta.servlet.ServletContext;
import java.util.function.Consumer;
import org.jsmesh.servlet.testing.JettyServer;
import org.jsmesh.servlet.testing.TestServer;

class JettyPageTest extends PageContract {
    @Override
    TestServer start(Consumer<ServletContext> application) throws Exception {
        return new JettyServer(application);
    }
}
