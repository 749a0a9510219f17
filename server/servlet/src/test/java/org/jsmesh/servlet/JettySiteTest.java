package org.jsmesh.servlet;

import org.jsmesh.servlet.testing.JettyServer;
import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.store.bucket.SiteStore;

class JettySiteTest extends SiteContract {
    @Override
    TestServer start(SiteStore site, ServletSettings settings) throws Exception {
        return new JettyServer(TestApplication.of(site, settings));
    }
}
