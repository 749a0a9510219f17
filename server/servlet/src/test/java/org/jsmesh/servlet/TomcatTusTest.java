package org.jsmesh.servlet;

import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.servlet.testing.TomcatServer;
import org.jsmesh.store.ModelStore;
import org.junit.jupiter.api.Tag;

@Tag("slow")
class TomcatTusTest extends TusContract {
    @Override
    TestServer start(ModelStore withUploads) throws Exception {
        return new TomcatServer(TestApplication.of(withUploads));
    }
}
