package org.jsmesh.servlet;

import org.jsmesh.servlet.testing.JettyServer;
import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.store.ModelStore;

class JettyPosterTest extends PosterContract {
    private static final int IDLE_MILLIS = 1000;

    @Override
    TestServer start(ModelStore store) throws Exception {
        return new JettyServer(TestApplication.of(store), IDLE_MILLIS);
    }
}
