package org.jsmesh.servlet;

import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.servlet.testing.TomcatServer;
import org.jsmesh.store.ModelStore;
import org.junit.jupiter.api.Tag;

@Tag("slow")
class TomcatSignedTest extends SignedContract {
    @Override
    TestServer start(ModelStore store, ServletSettings settings) throws Exception {
        return new TomcatServer(TestApplication.of(store, settings));
    }
}
