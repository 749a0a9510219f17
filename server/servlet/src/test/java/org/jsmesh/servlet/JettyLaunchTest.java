package org.jsmesh.servlet;

import org.jsmesh.servlet.testing.JettyServer;
import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.store.ModelStore;

class JettyLaunchTest extends LaunchContract {
    @Override
    TestServer start(ModelStore store, ServletSettings settings) throws Exception {
        return new JettyServer(TestApplication.of(store, settings));
    }
}
