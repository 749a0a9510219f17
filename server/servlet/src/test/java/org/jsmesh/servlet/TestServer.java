package org.jsmesh.servlet;

import java.net.URI;

/** A servlet container with the application in its root, on a free port of this machine. */
interface TestServer {
    /** Few, so that a test can have more clients than there are threads. */
    int THREADS = 12;

    /** Ends with a slash. */
    URI root();

    void stop() throws Exception;
}
