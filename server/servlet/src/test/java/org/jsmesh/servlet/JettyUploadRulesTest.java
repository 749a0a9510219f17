package org.jsmesh.servlet;

import org.jsmesh.servlet.testing.JettyServer;
import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.store.ModelStore;

class JettyUploadRulesTest extends UploadRulesContract {
    @Override
    TestServer start(ModelStore withUploads) throws Exception {
        return new JettyServer(TestApplication.of(withUploads));
    }
}
