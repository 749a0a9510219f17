package org.jsmesh.app.server;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.files.ModelInputs;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.sandbox.ModelEncoder;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Clients that ask for a model that is being encoded, and go away: nobody else has to wait for their turn. */
@Tag("slow")
class HangUpTest extends GuardedServer {
    private static final String PATH = "/m/slow/manifest.json";
    private static final int CLOSED = 1100;
    private static final int CONNECTIONS = 20;
    private static final int STREAMS = 50;

    @BeforeAll
    static void addSlowModel() throws Exception {
        Files.writeString(folder.resolve("models/slow.ply"), "no matter what");
    }

    /** Works until it is cancelled. */
    @Override
    ModelEncoder encoder() {
        return (Path model, Path archive, ProgressListener progress) -> {
            while (true) {
                progress.step("simplify", 0.5);
                Thread.sleep(5);
                if (progress.isCancelled()) return new ModelInputs();
            }
        };
    }

    @Test
    void shouldServeOthersWhileClosedConnectionsAreForgotten() throws Exception {
        for (int i = 0; i < CLOSED; i++) {
            try (Socket socket = connect()) {
                send(socket, "GET " + PATH + " HTTP/1.1\r\nHost: h\r\n\r\n");
            }
        }
        assertStillServes();
        assertForgotten();
    }

    @Test
    void shouldServeOthersWhileStreamsAreReset() throws Exception {
        List<Socket> sockets = new ArrayList<>();
        try {
            for (int i = 0; i < CONNECTIONS; i++) {
                Socket socket = connect();
                sockets.add(socket);
                socket.getOutputStream().write(asks());
            }
            Await.until("requests that wait", () -> store().runningEncodings() == 1);
            for (Socket socket : sockets) socket.getOutputStream().write(resets());
            assertStillServes();
            assertForgotten();
        } finally {
            for (Socket socket : sockets) socket.close();
        }
    }

    private static byte[] asks() throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.write(HostileHttp2Test.PREFACE.getBytes(StandardCharsets.US_ASCII));
        out.write(HostileHttp2Test.frame(HostileHttp2Test.SETTINGS, 0, 0));
        int whole = HostileHttp2Test.END_HEADERS | HostileHttp2Test.END_STREAM;
        for (int i = 0; i < STREAMS; i++)
            out.write(
                    HostileHttp2Test.frame(HostileHttp2Test.HEADERS, whole, 2 * i + 1, HostileHttp2Test.request(PATH)));
        return out.toByteArray();
    }

    private static byte[] resets() throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        byte[] cancel = {0, 0, 0, 8};
        for (int i = 0; i < STREAMS; i++)
            out.write(HostileHttp2Test.frame(HostileHttp2Test.RST_STREAM, 0, 2 * i + 1, cancel));
        return out.toByteArray();
    }

    /** While the encoding goes on. */
    private void assertForgotten() throws Exception {
        Await.until("the end of all requests", () -> server.metrics().text().contains("jsm_requests_running 0.0"));
        Await.until("the encoding alone", () -> store().runningEncodings() == 1);
    }
}
