package org.jsmesh.servlet;

import org.jsmesh.servlet.testing.JettyServer;
import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.store.ModelStore;

class JettyTusTest extends TusContract {
    @Override
    TestServer start(ModelStore withUploads) throws Exception {
        return new JettyServer(TestApplication.of(withUploads));
    }
}
