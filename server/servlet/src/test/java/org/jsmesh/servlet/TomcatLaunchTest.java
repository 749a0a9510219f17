package org.jsmesh.servlet;

import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.servlet.testing.TomcatServer;
import org.jsmesh.store.ModelStore;

class TomcatLaunchTest extends LaunchContract {
    @Override
    TestServer start(ModelStore store, ServletSettings settings) throws Exception {
        return new TomcatServer(TestApplication.of(store, settings));
    }
}
