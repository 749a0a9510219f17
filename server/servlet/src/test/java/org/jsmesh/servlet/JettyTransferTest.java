package org.jsmesh.servlet;

import org.jsmesh.servlet.testing.JettyServer;
import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.store.ModelStore;

class JettyTransferTest extends TransferContract {
    @Override
    TestServer start(ModelStore store) throws Exception {
        return new JettyServer(TestApplication.of(store));
    }
}
