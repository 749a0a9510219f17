package org.jsmesh.servlet;

import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.servlet.testing.TomcatServer;
import org.jsmesh.store.bucket.SiteStore;
import org.junit.jupiter.api.Tag;

@Tag("slow")
class TomcatSiteTest extends SiteContract {
    @Override
    TestServer start(SiteStore site, ServletSettings settings) throws Exception {
        return new TomcatServer(TestApplication.of(site, settings));
    }
}
