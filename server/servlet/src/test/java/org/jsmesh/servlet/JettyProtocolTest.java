package org.jsmesh.servlet;

import org.jsmesh.servlet.testing.JettyServer;
import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.store.ModelStore;

class JettyProtocolTest extends ProtocolContract {
    /** Shorter than a request may wait for an encoding. */
    private static final int IDLE_MILLIS = 1000;

    @Override
    TestServer start(ModelStore store) throws Exception {
        return new JettyServer(TestApplication.of(store), IDLE_MILLIS);
    }
}
