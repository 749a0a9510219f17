package org.jsmesh.app.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.app.TestKeystore;
import org.jsmesh.test.Await;
import org.jsmesh.upload.UploadSettings;
import org.jsmesh.upload.UploadTokens;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Clients that send or read byte by byte, always in time for a timeout of idle connections, to keep the others from
 * being served.
 */
@Tag("slow")
class SlowClientsTest extends GuardedServer {
    private static final int CLIENTS = 50;
    private static final long PACE_MILLIS = 20;
    private static final String TOKEN = "a-token-of-some-length";

    private int sent;

    @Override
    Limits limits() {
        return Limits.defaults().withMillis(400, 400, 1500, 60_000);
    }

    /** Sends the beginning, then byte by byte until the server has had enough of it. */
    private void drip(String beginning, String bytes) throws Exception {
        List<Socket> sockets = new ArrayList<>();
        try {
            for (int i = 0; i < CLIENTS; i++) {
                Socket socket = connect();
                sockets.add(socket);
                send(socket, beginning.replace("/m/sent ", "/m/sent-" + sent++ + " "));
            }
            assertStillServes();
            List<Socket> open = new ArrayList<>(sockets);
            long deadline = System.nanoTime() + PATIENCE_MILLIS * 1_000_000L;
            for (int at = 0; !open.isEmpty(); at++) {
                if (System.nanoTime() > deadline) throw new AssertionError(open.size() + " are still connected");
                String next = bytes.isEmpty() ? "" : bytes.substring(at % bytes.length(), at % bytes.length() + 1);
                open.removeIf(socket -> isOver(socket, next));
                Thread.sleep(PACE_MILLIS);
            }
        } finally {
            for (Socket socket : sockets) socket.close();
        }
        assertStillServes();
    }

    private void assertDropped(int connections) {
        assertThat(server.metrics().text()).contains("jsm_dropped_total " + connections + ".0\n");
    }

    private static boolean isOver(Socket socket, String next) {
        try {
            socket.getOutputStream().write(next.getBytes(java.nio.charset.StandardCharsets.ISO_8859_1));
            socket.setSoTimeout(1);
            return socket.getInputStream().read() < 0;
        } catch (java.net.SocketTimeoutException e) {
            return false;
        } catch (IOException e) {
            return true;
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"G", "GET /m/ HTTP/1.1\r\nHost: h\r\n", "GET /m/ HTTP/1.1\r\nHost: h\r\nX-"})
    void shouldDropThoseWhoseHeaderDoesNotEnd(String beginning) throws Exception {
        drip(beginning, "a");
        assertDropped(CLIENTS);
    }

    @Test
    void shouldDisconnectThoseWhoBeginHttp2Wrongly() throws Exception {
        drip("PRI * HTTP/2.0\r\n\r\n", "a");
    }

    @Test
    void shouldDropThoseWhoAskNothing() throws Exception {
        drip("", "");
        assertDropped(CLIENTS);
    }

    @Test
    void shouldDropThoseWhoDoNotEndTheHandshake() throws Exception {
        TestKeystore keystore = TestKeystore.in(folder);
        start(ServerSettings.defaults().withLimits(limits()).withKeystore(keystore.file(), keystore.password()));
        for (String beginning : List.of("", "\u0016", "\u0016\u0003\u0001\u0002\0\u0001\0\u0001\u00fc\u0003\u0003")) {
            try (Socket socket = connect()) {
                send(socket, beginning);
                assertThat(readToEnd(socket).length).as("an alert at most").isLessThan(100);
            }
        }
    }

    @Test
    void shouldDropThoseWhoseBodyDoesNotEnd() throws Exception {
        Path tokens = Files.writeString(folder.resolve("tokens"), TOKEN + "\n");
        store().acceptUploads(UploadSettings.of(UploadTokens.read(tokens)).withQueued(2 * CLIENTS));
        String upload = "POST /m/sent HTTP/1.1\r\nHost: h\r\nAuthorization: Bearer " + TOKEN
                + "\r\nContent-Type: application/octet-stream\r\n";
        drip(upload + "Content-Length: 100000\r\n\r\n", "a");
        assertDropped(CLIENTS);
        // Refused without reading, as its length is not told.
        drip(upload + "Transfer-Encoding: chunked\r\n\r\n", "1\r\na\r\n");
    }

    /** Only the server's own reading is in danger: who asks for bytes is answered whatever body comes behind. */
    @Test
    void shouldDisconnectThoseWhoseBodyNobodyReads() throws Exception {
        String body = "Content-Length: 100000\r\n\r\n";
        for (String request : List.of("PUT /m/bumpy", "GET " + archivePath)) {
            try (Socket socket = connect()) {
                send(socket, request + " HTTP/1.1\r\nHost: h\r\n" + body);
                assertThat(readToEnd(socket)).isNotEmpty(); // fails the test when the connection stays open
            }
        }
        assertStillServes();
    }

    @Test
    void shouldDropThoseWhoHardlyRead() throws Exception {
        try (Socket socket = connect()) {
            send(socket, requestLarge());
            InputStream in = socket.getInputStream();
            // What is in the client's own buffer it may go on to read.
            Await.until("the server to drop the connection", () -> {
                if (server.metrics().text().contains("jsm_dropped_total 1.0")) return true;
                in.read();
                Thread.sleep(PACE_MILLIS);
                return false;
            });
        }
        assertStillServes();
    }
}
