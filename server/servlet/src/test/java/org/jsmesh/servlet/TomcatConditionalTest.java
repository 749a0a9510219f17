package org.jsmesh.servlet;

import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.servlet.testing.TomcatServer;
import org.jsmesh.store.ModelStore;

class TomcatConditionalTest extends ConditionalContract {
    @Override
    TestServer start(ModelStore store) throws Exception {
        return new TomcatServer(TestApplication.of(store));
    }
}
