package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.http.HttpResponse;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.servlet.http.Digests;
import org.jsmesh.servlet.testing.SlowReader;
import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.store.TestArchives;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** How every container has to send what is larger than a connection takes at once. */
abstract class TransferContract extends ContractServer {
    private static final int READERS = 40;

    /** More than the kernel takes from the server for a reader that does not read. */
    private static final byte[] LARGE = TestArchives.of(11, 1000, 12_000_000, 4_000_000);

    private String url;

    @BeforeEach
    void writeLargeArchive() throws Exception {
        Files.write(folder.resolve("large.jsm"), LARGE);
        store.list(); // looks at once
        get("m/large/manifest.json");
        url = "m/large/" + Digests.sha256(LARGE) + ".jsm";
    }

    /** The server has fewer threads than there are readers. */
    @Tag("slow")
    @Test
    void shouldHoldNoThreadForSlowReaders() throws Exception {
        assertThat(READERS).isGreaterThan(TestServer.THREADS);
        List<SlowReader> readers = new ArrayList<>();
        try {
            for (int i = 0; i < READERS; i++) readers.add(new SlowReader(server.root(), url));
            for (SlowReader reader : readers) assertThat(reader.header()).startsWith("HTTP/1.1 200");
            assertThat(get(archiveUrl()).body())
                    .as("others are served meanwhile")
                    .isEqualTo(ARCHIVE);
            for (SlowReader reader : readers)
                assertThat(Arrays.equals(reader.body(), LARGE)).isTrue();
        } finally {
            for (SlowReader reader : readers) reader.close();
        }
    }

    @Test
    void shouldSendLargeRangesToTheLastByte() throws Exception {
        byte[] tail = get(url, "Range", "bytes=3-").body();
        assertThat(Arrays.equals(tail, Arrays.copyOfRange(LARGE, 3, LARGE.length)))
                .isTrue();
        byte[] batch = get(url.replace(".jsm", "/batches/1-1")).body();
        assertThat(Arrays.equals(batch, Arrays.copyOfRange(LARGE, 1000, 12_001_000)))
                .isTrue();
    }

    /** A body that ends early must not look whole. */
    @Test
    void shouldCutTheConnectionWhenSendingFails() throws Exception {
        for (int writes : new int[] {1, 20}) {
            assertThatThrownBy(() -> get(url, FailingWrites.FIELD, Integer.toString(writes)))
                    .as("%d writes", writes)
                    .isInstanceOf(IOException.class);
        }
        try {
            HttpResponse<byte[]> early = get(url, FailingWrites.FIELD, "0");
            assertThat(early.statusCode()).isEqualTo(500);
            assertThat(early.headers().firstValue("ETag")).isEmpty();
        } catch (IOException e) {
            // Tomcat cuts the connection although nothing was sent, which tells no lie either.
        }
        assertThat(get(archiveUrl()).body()).as("others are served after it").isEqualTo(ARCHIVE);
    }

    /** What has gone out is right to its last byte. */
    @Test
    void shouldCutTheConnectionWhenTheFileIsCut() throws Exception {
        try (SlowReader reader = new SlowReader(server.root(), url)) {
            assertThat(reader.header()).containsIgnoringCase("Content-Length: " + LARGE.length);
            try (FileChannel file = FileChannel.open(folder.resolve("large.jsm"), StandardOpenOption.WRITE)) {
                file.truncate(4096);
            }
            byte[] body = reader.body();
            assertThat(body.length).isLessThan(LARGE.length);
            assertThat(Arrays.equals(body, Arrays.copyOf(LARGE, body.length))).isTrue();
        }
        assertThat(get(archiveUrl()).body()).as("others are served after it").isEqualTo(ARCHIVE);
    }

    @Test
    void shouldGoOnWhenAReaderGoesAway() throws Exception {
        for (int i = 0; i < READERS; i++) {
            try (SlowReader reader = new SlowReader(server.root(), url)) {
                assertThat(reader.header()).startsWith("HTTP/1.1 200");
            }
        }
        assertThat(get(archiveUrl()).body()).isEqualTo(ARCHIVE);
    }
}
