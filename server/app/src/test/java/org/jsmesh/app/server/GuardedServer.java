package org.jsmesh.app.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.Random;
import org.jsmesh.app.Bumpy;
import org.jsmesh.app.Cli;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.sandbox.ModelEncoder;
import org.jsmesh.sandbox.ModelFilesEncoder;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A server with one archive, clients that do what they should not, and one that only wants the archive. */
@Timeout(90)
public abstract class GuardedServer {
    /** How long a client waits for the server to answer or to close; that it happens is tested, not when. */
    public static final int PATIENCE_MILLIS = 30_000;

    @TempDir
    public static Path folder;

    static byte[] archive;
    public static String archivePath;

    /** More than the kernel takes from the server for a reader that does not read. */
    static byte[] large;

    static String largePath;
    private static final int LARGE_BYTES = 16_000_000;

    private ModelStore store;
    public JsmServer server;

    @BeforeAll
    static void encode() throws Exception {
        Path ply = folder.resolve("bumpy.ply");
        Bumpy.write(ply, 120);
        Files.createDirectories(folder.resolve("models"));
        Path jsm = folder.resolve("models").resolve("bumpy.jsm");
        Cli.ok("encode", ply, "-o", jsm, "--quiet", "--quality", "fast");
        archive = Files.readAllBytes(jsm);
        archivePath = path("bumpy", archive);
        large = encodeLarge();
        largePath = path("large", large);
    }

    private static String path(String id, byte[] bytes) throws Exception {
        byte[] hash = MessageDigest.getInstance("SHA-256").digest(bytes);
        return "/m/" + id + "/" + HexFormat.of().formatHex(hash) + ".jsm";
    }

    /** A tetrahedron with a picture of noise. */
    private static byte[] encodeLarge() throws IOException {
        String obj = "mtllib large.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl a\n"
                + "f 1/1 2/2 3/3\nf 1/1 4/2 2/3\nf 2/1 4/2 3/3\nf 1/1 3/2 4/3\n";
        Files.writeString(folder.resolve("large.obj"), obj);
        Files.writeString(folder.resolve("large.mtl"), "newmtl a\nmap_Kd large.png\n");
        byte[] noise = new byte[LARGE_BYTES];
        new Random(1).nextBytes(noise);
        System.arraycopy(new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'}, 0, noise, 0, 8);
        Files.write(folder.resolve("large.png"), noise);
        Path jsm = folder.resolve("models").resolve("large.jsm");
        Cli.ok("encode", folder.resolve("large.obj"), "-o", jsm, "--quiet");
        return Files.readAllBytes(jsm);
    }

    /** What the tests of a class start with. */
    Limits limits() {
        return Limits.defaults();
    }

    /** Encodes the models of a class that are not archives. */
    ModelEncoder encoder() {
        return new ModelFilesEncoder(EncoderSettings.defaults());
    }

    @BeforeEach
    void start() throws IOException {
        start(ServerSettings.defaults().withLimits(limits()));
    }

    final void start(ServerSettings settings) throws IOException {
        start(settings, null);
    }

    final void start(ServerSettings settings, AccessLog log) throws IOException {
        stop();
        StoreSettings models = StoreSettings.of(folder.resolve("models")).withCache(folder.resolve("cache"));
        store = new ModelStore(models, encoder());
        server = JsmServer.start(settings, store, log);
    }

    @AfterEach
    final void stop() {
        if (server != null) server.close();
        if (store != null) store.close();
    }

    final ModelStore store() {
        return store;
    }

    /** Whoever behaves gets the archive, whole. */
    final void assertStillServes() throws Exception {
        HttpRequest request =
                HttpRequest.newBuilder(server.uri().resolve(archivePath)).build();
        HttpResponse<byte[]> answer = HttpClient.newHttpClient().send(request, HttpResponse.BodyHandlers.ofByteArray());
        assertThat(answer.statusCode()).isEqualTo(200);
        assertThat(answer.body()).isEqualTo(archive);
    }

    final Socket connect() throws IOException {
        Socket socket = new Socket();
        // A small window, so that the kernel does not read for the client.
        socket.setReceiveBufferSize(8 << 10);
        URI uri = server.uri();
        socket.connect(new InetSocketAddress(uri.getHost(), uri.getPort()));
        socket.setSoTimeout(PATIENCE_MILLIS);
        return socket;
    }

    /** Sends, and answers with everything that comes until the server closes or cuts the connection. */
    final String exchange(String request) throws IOException {
        try (Socket socket = connect()) {
            send(socket, request);
            return new String(readToEnd(socket), StandardCharsets.ISO_8859_1);
        }
    }

    /** Sends as much as the server takes before it closes. */
    static void send(Socket socket, String text) {
        try {
            socket.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
        } catch (IOException e) {
            // Closed; what was answered tells why.
        }
    }

    static byte[] readToEnd(Socket socket) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        byte[] block = new byte[1 << 16];
        try {
            InputStream in = socket.getInputStream();
            for (int n = in.read(block); n >= 0; n = in.read(block)) bytes.write(block, 0, n);
        } catch (java.net.SocketTimeoutException e) {
            throw new AssertionError("the server neither answers nor closes", e);
        } catch (IOException e) {
            // Cut.
        }
        return bytes.toByteArray();
    }

    static String requestLarge() {
        return "GET " + largePath + " HTTP/1.1\r\nHost: h\r\nConnection: close\r\n\r\n";
    }

    /** Requests for the archive, one behind the other on one connection. */
    static String pipelined(int requests) {
        return ("GET " + archivePath + " HTTP/1.1\r\nHost: h\r\n\r\n").repeat(requests);
    }
}
