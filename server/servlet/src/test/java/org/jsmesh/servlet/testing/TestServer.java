package org.jsmesh.servlet.testing;

import java.net.URI;

/** A servlet container with one web application, on a free port of this machine. */
public interface TestServer {
    /** Few, so that a test can have more clients than there are threads. */
    int THREADS = 12;

    /** Of the application; ends with a slash. */
    URI root();

    void stop() throws Exception;
}
