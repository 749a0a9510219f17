package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.channels.FileChannel;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import org.jsmesh.servlet.testing.JettyServer;
import org.jsmesh.servlet.testing.SlowReader;
import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.store.ModelStore;
import org.junit.jupiter.api.Test;

class JettyTransferTest extends TransferContract {
    @Override
    TestServer start(ModelStore store) throws Exception {
        return new JettyServer(TestApplication.of(store));
    }

    /** What has gone out is right to its last byte. */
    @Test
    void shouldCutTheConnectionWhenTheFileIsCut() throws Exception {
        try (SlowReader reader = new SlowReader(server.root(), url)) {
            assertThat(reader.header()).contains("Content-Length: " + LARGE.length);
            try (FileChannel file = FileChannel.open(folder.resolve("large.jsm"), StandardOpenOption.WRITE)) {
                file.truncate(4096);
            }
            byte[] body = reader.body();
            assertThat(body.length).isLessThan(LARGE.length);
            assertThat(Arrays.equals(body, Arrays.copyOf(LARGE, body.length))).isTrue();
        }
        assertThat(get(archiveUrl()).body()).as("others are served after it").isEqualTo(ARCHIVE);
    }
}
