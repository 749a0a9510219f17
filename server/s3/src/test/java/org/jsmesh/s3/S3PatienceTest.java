package org.jsmesh.s3;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.file.FileSystemException;
import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A service that takes requests and falls silent. Without a bound each of them would take minutes. */
@Timeout(40)
class S3PatienceTest {
    private static final int BYTES = 10;

    private final Map<String, String> before = new HashMap<>();
    private final ExecutorService threads = Executors.newCachedThreadPool();
    private final CountDownLatch never = new CountDownLatch(1);
    private HttpServer server;
    private ObjectStore store;

    @BeforeEach
    void start() throws IOException {
        server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
        server.setExecutor(threads);
        server.createContext("/", exchange -> {
            if (exchange.getRequestMethod().equals("GET")) {
                exchange.getResponseHeaders().set("ETag", "\"one\"");
                exchange.getResponseHeaders().set("Content-Range", "bytes 0-" + (BYTES - 1) + "/" + BYTES);
                exchange.sendResponseHeaders(206, BYTES);
                exchange.getResponseBody().write(1);
                exchange.getResponseBody().flush();
            }
            try {
                never.await();
            } catch (InterruptedException e) {
                throw new IOException(e);
            }
        });
        server.start();
        set("aws.endpointUrlS3", "http://127.0.0.1:" + server.getAddress().getPort());
        set("aws.accessKeyId", "a");
        set("aws.secretAccessKey", "b");
        store = new S3ObjectStoreProvider().open("s3://bucket/p", Duration.ofMillis(600));
    }

    private void set(String name, String value) {
        before.put(name, System.setProperty(name, value));
    }

    @AfterEach
    void stop() throws IOException {
        before.forEach((name, value) -> {
            if (value == null) System.clearProperty(name);
            else System.setProperty(name, value);
        });
        store.close();
        never.countDown();
        server.stop(0);
        threads.shutdownNow();
    }

    @Test
    void shouldGiveUpARequestThatIsNotAnswered() {
        assertThatThrownBy(() -> store.find("k"))
                .isInstanceOf(FileSystemException.class)
                .hasMessageContaining("Check the");
    }

    @Test
    void shouldGiveUpABodyThatStops() {
        StoredObject object = new StoredObject("k", BYTES, "\"one\"", Instant.EPOCH);
        assertThatThrownBy(() -> store.read(object, 0, ByteBuffer.allocate(BYTES)))
                .isInstanceOf(IOException.class);
    }
}
