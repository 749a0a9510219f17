package org.jsmesh.servlet;

import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.servlet.testing.TomcatServer;
import org.jsmesh.store.ModelStore;

class TomcatPosterTest extends PosterContract {
    @Override
    TestServer start(ModelStore store) throws Exception {
        return new TomcatServer(TestApplication.of(store));
    }
}
