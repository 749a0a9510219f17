package org.jsmesh.app.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.DataInputStream;
import java.io.IOException;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.atomic.AtomicInteger;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Connections of HTTP/2 that carry the requests of many, as those of proxies do. */
@Tag("slow")
class SlowStreamsTest extends GuardedServer {
    private static final int ALL = 1 << 30;

    @Override
    Limits limits() {
        return Limits.defaults().withMillis(10_000, 10_000, 2000, 60_000);
    }

    private record Frame(int type, int flags, int stream, byte[] payload) {
        static Frame read(DataInputStream in) throws IOException {
            int length = in.readUnsignedShort() << 8 | in.readUnsignedByte();
            int type = in.readUnsignedByte();
            int flags = in.readUnsignedByte();
            int stream = in.readInt();
            return new Frame(type, flags, stream, in.readNBytes(length));
        }

        boolean endsStream() {
            return (type == HostileHttp2Test.DATA || type == HostileHttp2Test.HEADERS)
                    && (flags & HostileHttp2Test.END_STREAM) != 0;
        }
    }

    private static byte[] grant(int stream, int bytes) {
        byte[] window = {(byte) (bytes >> 24), (byte) (bytes >> 16), (byte) (bytes >> 8), (byte) bytes};
        return HostileHttp2Test.frame(HostileHttp2Test.WINDOW_UPDATE, 0, stream, window);
    }

    private static byte[] ask(int stream, String path) {
        int flags = HostileHttp2Test.END_HEADERS | HostileHttp2Test.END_STREAM;
        return HostileHttp2Test.frame(HostileHttp2Test.HEADERS, flags, stream, HostileHttp2Test.request(path));
    }

    private Socket begin() throws IOException {
        Socket socket = connect();
        socket.getOutputStream().write(HostileHttp2Test.PREFACE.getBytes(StandardCharsets.US_ASCII));
        socket.getOutputStream().write(HostileHttp2Test.frame(HostileHttp2Test.SETTINGS, 0, 0));
        socket.getOutputStream().write(grant(0, ALL));
        return socket;
    }

    /**
     * Reads a stream to its end; answers with the bytes of content, or -1 if the stream was reset. Others may be reset
     * meanwhile.
     */
    private static int readStream(DataInputStream in, int stream) throws IOException {
        int bytes = 0;
        while (true) {
            Frame frame = Frame.read(in);
            if (frame.stream() != stream) continue;
            if (frame.type() == HostileHttp2Test.DATA) bytes += frame.payload().length;
            if (frame.type() == HostileHttp2Test.RST_STREAM) {
                assertThat(frame.payload()).as("CANCEL").containsExactly(0, 0, 0, 8);
                return -1;
            }
            if (frame.endsStream()) return bytes;
        }
    }

    @Test
    void shouldResetTheSlowStreamAlone() throws Exception {
        try (Socket socket = begin()) {
            DataInputStream in = new DataInputStream(socket.getInputStream());
            // Nobody lets the streams 1 and 3 have more than the first 64 kB.
            socket.getOutputStream().write(ask(1, largePath));
            socket.getOutputStream().write(ask(3, largePath));
            assertThat(readStream(in, 1)).isEqualTo(-1);
            assertThat(dropped()).isBetween(1, 2);
            socket.getOutputStream().write(ask(5, archivePath));
            socket.getOutputStream().write(grant(5, ALL));
            assertThat(readStream(in, 5)).isEqualTo(archive.length);
        }
        assertStillServes();
    }

    @Test
    void shouldResetASlowStreamBesideAFastOne() throws Exception {
        try (Socket socket = begin()) {
            DataInputStream in = new DataInputStream(socket.getInputStream());
            socket.getOutputStream().write(ask(1, largePath));
            AtomicInteger next = new AtomicInteger(3);
            Await.until("the server to drop the slow stream", () -> {
                int stream = next.getAndAdd(2);
                socket.getOutputStream().write(ask(stream, largePath));
                socket.getOutputStream().write(grant(stream, ALL));
                assertThat(readStream(in, stream)).isEqualTo(large.length);
                return dropped() > 0;
            });
            int stream = next.get();
            socket.getOutputStream().write(ask(stream, archivePath));
            socket.getOutputStream().write(grant(stream, ALL));
            assertThat(readStream(in, stream)).isEqualTo(archive.length);
        }
        assertThat(dropped()).isEqualTo(1);
    }

    private int dropped() {
        String line = server.metrics()
                .text()
                .lines()
                .filter(l -> l.startsWith("jsm_dropped_total "))
                .findFirst()
                .orElseThrow();
        return (int) Double.parseDouble(line.substring(line.indexOf(' ')));
    }
}
