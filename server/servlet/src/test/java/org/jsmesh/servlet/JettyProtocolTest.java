package org.jsmesh.servlet;

import org.jsmesh.store.ModelStore;

class JettyProtocolTest extends ProtocolContract {
    @Override
    TestServer start(ModelStore store) throws Exception {
        return new JettyServer(store);
    }
}
