package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.jsmesh.servlet.testing.JettyServer;
import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.store.ModelStore;
import org.junit.jupiter.api.Test;

class JettyProtocolTest extends ProtocolContract {
    /** Short, so that a test can outlast it. */
    private static final int IDLE_MILLIS = 1000;

    @Override
    TestServer start(ModelStore store) throws Exception {
        return new JettyServer(TestApplication.of(store), IDLE_MILLIS);
    }

    @Test
    void shouldWaitForAnEncodingLongerThanAConnectionMayIdle() throws Exception {
        Files.writeString(folder.resolve("slow.ply"), "slow");
        get("m/");
        encoder.hold();
        HttpRequest request = request("m/slow/manifest.json").build();
        CompletableFuture<HttpResponse<byte[]>> answer =
                client.sendAsync(request, HttpResponse.BodyHandlers.ofByteArray());
        encoder.awaitRunning(1);
        Thread.sleep(3 * IDLE_MILLIS);
        encoder.release();
        assertThat(answer.get(30, TimeUnit.SECONDS).statusCode()).isEqualTo(200);
        assertThat(encoder.begun()).isEqualTo(1);
    }
}
