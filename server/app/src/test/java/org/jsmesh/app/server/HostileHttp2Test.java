package org.jsmesh.app.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Frames of HTTP/2 that mean harm, written by hand: the server ends the connection and goes on serving others. */
@Tag("slow")
class HostileHttp2Test extends GuardedServer {
    static final String PREFACE = "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n";
    static final int DATA = 0;
    static final int HEADERS = 1;
    static final int RST_STREAM = 3;
    static final int SETTINGS = 4;
    private static final int PING = 6;
    private static final int GOAWAY = 7;
    static final int WINDOW_UPDATE = 8;
    private static final int CONTINUATION = 9;
    static final int END_STREAM = 1;
    static final int END_HEADERS = 4;
    private static final int FLOOD = 20_000;

    @Override
    Limits limits() {
        return Limits.defaults().withMillis(2000, 2000, 5000, 5000);
    }

    static byte[] frame(int type, int flags, int stream, byte... payload) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.write(payload.length >> 16);
        out.write(payload.length >> 8);
        out.write(payload.length);
        out.write(type);
        out.write(flags);
        for (int shift = 24; shift >= 0; shift -= 8) out.write(stream >> shift);
        out.writeBytes(payload);
        return out.toByteArray();
    }

    /** A request for the archive; HPACK (RFC 7541): fields of the static table and literals that are not indexed. */
    private static byte[] request() {
        return request(archivePath);
    }

    static byte[] request(String path) {
        ByteArrayOutputStream block = new ByteArrayOutputStream();
        block.write(0x82); // :method GET
        block.write(0x86); // :scheme http
        literal(block, 4, path); // :path
        literal(block, 1, "localhost"); // :authority
        return block.toByteArray();
    }

    private static void literal(ByteArrayOutputStream block, int name, String value) {
        block.write(name);
        byte[] bytes = value.getBytes(StandardCharsets.US_ASCII);
        if (bytes.length > 126) throw new IllegalArgumentException(value);
        block.write(bytes.length);
        block.writeBytes(bytes);
    }

    private Socket begin() throws IOException {
        Socket socket = connect();
        socket.getOutputStream().write(PREFACE.getBytes(StandardCharsets.US_ASCII));
        socket.getOutputStream().write(frame(SETTINGS, 0, 0));
        return socket;
    }

    /** Sends frames until the server has had enough, which it must have before so many. */
    private void flood(FrameOf frames) throws Exception {
        try (Socket socket = begin()) {
            boolean closed = false;
            for (int i = 0; i < FLOOD && !closed; i++) {
                try {
                    socket.getOutputStream().write(frames.number(i));
                } catch (IOException e) {
                    closed = true;
                }
            }
            byte[] answer = readToEnd(socket); // fails the test when the connection stays open
            assertThat(answer.length).isLessThan(100 * archive.length);
        }
        assertStillServes();
    }

    private interface FrameOf {
        byte[] number(int i);
    }

    private static byte[] join(byte[]... parts) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        for (byte[] part : parts) out.writeBytes(part);
        return out.toByteArray();
    }

    @Test
    void shouldAnswerAGoodRequest() throws Exception {
        try (Socket socket = begin()) {
            socket.getOutputStream().write(frame(HEADERS, END_HEADERS | END_STREAM, 1, request()));
            socket.getOutputStream().write(frame(GOAWAY, 0, 0, new byte[8]));
            byte[] answer = readToEnd(socket);
            assertThat(answer.length).isGreaterThan(archive.length);
        }
    }

    /** CVE-2023-44487. */
    @Test
    void shouldEndRapidResets() throws Exception {
        byte[] block = request();
        byte[] cancel = {0, 0, 0, 8};
        flood(i -> join(
                frame(HEADERS, END_HEADERS | END_STREAM, 2 * i + 1, block), frame(RST_STREAM, 0, 2 * i + 1, cancel)));
    }

    /** The server is made to reset its streams itself. */
    @Test
    void shouldEndStreamsThatBreakTheirWindow() throws Exception {
        byte[] block = request();
        byte[] tooMuch = {0x7f, (byte) 0xff, (byte) 0xff, (byte) 0xff};
        flood(i -> join(
                frame(HEADERS, END_HEADERS | END_STREAM, 2 * i + 1, block),
                frame(WINDOW_UPDATE, 0, 2 * i + 1, tooMuch),
                frame(WINDOW_UPDATE, 0, 2 * i + 1, tooMuch)));
    }

    @Test
    void shouldEndFloodsOfPings() throws Exception {
        flood(i -> frame(PING, 0, 0, new byte[8]));
    }

    @Test
    void shouldEndFloodsOfSettings() throws Exception {
        flood(i -> frame(SETTINGS, 0, 0, (byte) 0, (byte) 3, (byte) 0, (byte) 0, (byte) 0, (byte) i));
    }

    @Test
    void shouldEndFloodsOfContinuations() throws Exception {
        byte[] fields = new byte[8000];
        Arrays.fill(fields, (byte) 0x82);
        flood(i -> i == 0 ? frame(HEADERS, 0, 1, request()) : frame(CONTINUATION, 0, 1, fields));
    }

    @Test
    void shouldEndFloodsOfEmptyContinuations() throws Exception {
        flood(i -> i == 0 ? frame(HEADERS, 0, 1, request()) : frame(CONTINUATION, 0, 1));
    }

    @Test
    void shouldEndFloodsOfEmptyData() throws Exception {
        flood(i -> i == 0 ? frame(HEADERS, END_HEADERS, 1, request()) : frame(DATA, 0, 1));
    }

    @Test
    void shouldEndFramesOfStreamsThatNeverWere() throws Exception {
        flood(i -> frame(DATA, 0, 2 * i + 1, new byte[10]));
    }

    @Test
    void shouldEndFramesLargerThanAgreed() throws Exception {
        flood(i -> frame(HEADERS, END_HEADERS, 2 * i + 1, new byte[1 << 20]));
    }

    /** A small table entry that many references blow up. */
    @Test
    void shouldEndHeadersThatUnfoldToMuchMore() throws Exception {
        ByteArrayOutputStream block = new ByteArrayOutputStream();
        block.writeBytes(request());
        block.write(0x40); // a new field, kept in the table
        block.write(1);
        block.write('x');
        block.write(0x7f);
        block.write(0xff - 0x7f - 56); // 127 + 72
        byte[] value = new byte[199];
        Arrays.fill(value, (byte) 'v');
        block.writeBytes(value);
        byte[] references = new byte[12_000];
        Arrays.fill(references, (byte) 0xbe); // the newest field of the table
        block.writeBytes(references);
        try (Socket socket = begin()) {
            socket.getOutputStream().write(frame(HEADERS, END_HEADERS | END_STREAM, 1, block.toByteArray()));
            socket.getOutputStream().write(frame(GOAWAY, 0, 0, new byte[8]));
            assertThat(readToEnd(socket).length).isLessThan(archive.length);
        }
        assertStillServes();
    }

    @Test
    void shouldNotKeepAConnectionForPingsAlone() throws Exception {
        try (Socket socket = begin()) {
            socket.getOutputStream().write(frame(HEADERS, END_HEADERS | END_STREAM, 1, request()));
            long deadline = System.nanoTime() + PATIENCE_MILLIS * 1_000_000L;
            boolean open = true;
            byte[] block = new byte[1 << 16];
            while (open) {
                assertThat(System.nanoTime()).as("still open").isLessThan(deadline);
                try {
                    socket.getOutputStream().write(frame(PING, 0, 0, new byte[8]));
                    socket.setSoTimeout(100);
                    open = socket.getInputStream().read(block) >= 0;
                } catch (java.net.SocketTimeoutException e) {
                    // Not yet.
                } catch (IOException e) {
                    open = false;
                }
                Thread.sleep(50);
            }
        }
        assertStillServes();
    }

    @Test
    void shouldDropThoseWhoseWindowStaysShut() throws Exception {
        try (Socket socket = connect()) {
            socket.getOutputStream().write(PREFACE.getBytes(StandardCharsets.US_ASCII));
            // Streams may send one byte at a time.
            socket.getOutputStream()
                    .write(frame(SETTINGS, 0, 0, (byte) 0, (byte) 4, (byte) 0, (byte) 0, (byte) 0, (byte) 1));
            for (int i = 0; i < 50; i++)
                socket.getOutputStream().write(frame(HEADERS, END_HEADERS | END_STREAM, 2 * i + 1, request()));
            assertStillServes();
            assertThat(readToEnd(socket).length).isLessThan(archive.length);
        }
        assertStillServes();
    }
}
