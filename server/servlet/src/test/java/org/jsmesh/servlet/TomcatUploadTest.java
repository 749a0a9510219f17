package org.jsmesh.servlet;

import org.jsmesh.store.ModelStore;

class TomcatUploadTest extends UploadContract {
    @Override
    TestServer start(ModelStore withUploads) throws Exception {
        return new TomcatServer(withUploads);
    }
}
