package org.jsmesh.webapp;

import jakarta.servlet.ServletContext;
import java.util.function.Consumer;
import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.servlet.testing.TomcatServer;

class TomcatPageTest extends PageContract {
    @Override
    TestServer start(Consumer<ServletContext> application) throws Exception {
        return new TomcatServer(application);
    }
}
