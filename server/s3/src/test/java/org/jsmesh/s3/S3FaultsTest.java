package org.jsmesh.s3;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.nio.ByteBuffer;
import java.nio.file.FileSystemException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.jsmesh.objects.Condition;
import org.jsmesh.objects.ObjectConflictException;
import org.jsmesh.objects.ObjectContent;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;
import org.jsmesh.objects.Upload;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import software.amazon.awssdk.auth.credentials.AwsBasicCredentials;
import software.amazon.awssdk.auth.credentials.AwsCredentialsProvider;
import software.amazon.awssdk.auth.credentials.StaticCredentialsProvider;
import software.amazon.awssdk.core.exception.SdkClientException;
import software.amazon.awssdk.http.urlconnection.UrlConnectionHttpClient;
import software.amazon.awssdk.regions.Region;
import software.amazon.awssdk.services.s3.S3Client;

/** A service that fails. */
class S3FaultsTest {
    private static final byte[] CONTENT = "0123456789".getBytes(UTF_8);
    private static final Upload UPLOAD = Upload.of("k", ObjectContent.of(CONTENT));

    private final List<String> asked = new CopyOnWriteArrayList<>();
    private final ExecutorService threads = Executors.newCachedThreadPool();
    private HttpServer server;
    private ObjectStore store;

    private interface Handler {
        void handle(HttpExchange exchange, int number) throws IOException;
    }

    @BeforeEach
    void start() throws IOException {
        server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
        server.setExecutor(threads);
        server.start();
        store = store(StaticCredentialsProvider.create(AwsBasicCredentials.create("a", "b")));
    }

    private ObjectStore store(AwsCredentialsProvider credentials) {
        S3Client client = S3Client.builder()
                .httpClientBuilder(UrlConnectionHttpClient.builder())
                .endpointOverride(
                        URI.create("http://127.0.0.1:" + server.getAddress().getPort()))
                .forcePathStyle(true)
                .region(Region.EU_WEST_1)
                .credentialsProvider(credentials)
                .build();
        return new S3ObjectStore(client, new S3Place("bucket", "p/"), 1 << 20, 1 << 19, 1000);
    }

    @AfterEach
    void stop() throws IOException {
        store.close();
        server.stop(0);
        threads.shutdownNow();
    }

    private void answer(Handler handler) {
        server.createContext("/", exchange -> {
            asked.add(exchange.getRequestMethod());
            exchange.getRequestBody().readAllBytes();
            handler.handle(exchange, asked.size());
            exchange.close();
        });
    }

    private static void send(HttpExchange exchange, int status, String code) throws IOException {
        byte[] body = ("<?xml version=\"1.0\"?><Error><Code>" + code + "</Code><Message>said</Message></Error>")
                .getBytes(UTF_8);
        boolean isHead = exchange.getRequestMethod().equals("HEAD");
        exchange.getResponseHeaders().set("Content-Type", "application/xml");
        exchange.sendResponseHeaders(status, isHead ? -1 : body.length);
        if (!isHead) exchange.getResponseBody().write(body);
    }

    private static void stored(HttpExchange exchange) throws IOException {
        exchange.getResponseHeaders().set("ETag", "\"new\"");
        exchange.sendResponseHeaders(200, -1);
    }

    @Test
    void shouldAskAgainWhenTheServiceIsBusy() throws Exception {
        answer((exchange, number) -> {
            if (number < 3) send(exchange, 503, "SlowDown");
            else stored(exchange);
        });
        assertThat(store.put(UPLOAD).tag()).isEqualTo("\"new\"");
        assertThat(asked).hasSize(3);
    }

    @Test
    void shouldTellWhenTheServiceStaysBusy() {
        answer((exchange, number) -> send(exchange, 503, "SlowDown"));
        assertThatThrownBy(() -> store.put(UPLOAD))
                .isInstanceOf(FileSystemException.class)
                .hasMessage("s3://bucket/p/k: the service is overloaded or failing (503 SlowDown)"
                        + " and was asked several times. Try again later");
    }

    @Test
    void shouldNameTheRightThatIsWanting() {
        answer((exchange, number) -> send(exchange, 403, "AccessDenied"));
        assertThatThrownBy(() -> store.put(UPLOAD)).hasMessageContaining("the right s3:PutObject");
        assertThatThrownBy(() -> store.open("k").close())
                .hasMessageContaining("s3://bucket/p/k: access is refused (403).")
                .hasMessageContaining("the right s3:GetObject, and s3:ListBucket");
        assertThatThrownBy(() -> store.find("k")).hasMessageContaining("s3:GetObject");
        assertThatThrownBy(() -> store.delete("k")).hasMessageContaining("s3:DeleteObject");
        assertThatThrownBy(() -> store.list("", "", o -> true))
                .hasMessage(
                        "s3://bucket/p: access is refused (403). Give the credentials in use the right s3:ListBucket");
    }

    @Test
    void shouldTellWhatIsSetWrong() {
        List<String> codes = List.of("RequestTimeTooSkewed", "InvalidAccessKeyId", "SignatureDoesNotMatch");
        List<String> remedies = List.of("Set it", "Check the credentials and the endpoint", "Check the credentials");
        answer((exchange, number) ->
                send(exchange, 403, exchange.getRequestURI().getPath().substring(10)));
        for (int i = 0; i < codes.size(); i++) {
            String code = codes.get(i);
            assertThatThrownBy(() -> store.open(code).close())
                    .isInstanceOf(FileSystemException.class)
                    .message()
                    .endsWith(remedies.get(i));
        }
    }

    @Test
    void shouldTellOfAnotherRegion() {
        answer((exchange, number) -> send(exchange, 301, "PermanentRedirect"));
        assertThatThrownBy(() -> store.open("k").close()).hasMessageContaining("Set AWS_REGION");
    }

    @Test
    void shouldTellOfCredentialsThatAreMissing() throws Exception {
        try (ObjectStore without = store(() -> {
            throw SdkClientException.create("Unable to load credentials from any of the providers");
        })) {
            assertThatThrownBy(() -> without.find("k"))
                    .isInstanceOf(FileSystemException.class)
                    .hasMessageContaining("there are no credentials. Set AWS_ACCESS_KEY_ID");
        }
    }

    @Test
    void shouldTellOfAServiceThatCannotBeReached() {
        server.stop(0);
        assertThatThrownBy(() -> store.find("k"))
                .isInstanceOf(FileSystemException.class)
                .hasMessageContaining("s3://bucket/p/k: the service cannot be reached")
                .hasMessageContaining("Check the endpoint and the network");
    }

    @Test
    void shouldKnowItsOwnWriteWhenTheAnswerWasLost() throws Exception {
        List<String> writes = new ArrayList<>();
        answer((exchange, number) -> {
            switch (number) {
                case 1 -> {
                    writes.add(exchange.getRequestHeaders().getFirst("x-amz-meta-jsm-write"));
                    send(exchange, 500, "InternalError"); // It was written nevertheless.
                }
                case 2 -> send(exchange, 412, "PreconditionFailed");
                default -> {
                    exchange.getResponseHeaders().set("x-amz-meta-jsm-write", writes.get(0));
                    exchange.getResponseHeaders().set("Last-Modified", "Tue, 24 Nov 2026 10:00:00 GMT");
                    exchange.getResponseHeaders().set("Content-Length", "10");
                    stored(exchange);
                }
            }
        });
        StoredObject object = store.put(UPLOAD.withCondition(Condition.ABSENT));
        assertThat(object.tag()).isEqualTo("\"new\"");
        assertThat(asked).containsExactly("PUT", "PUT", "HEAD");
    }

    @Test
    void shouldTellOfTheWriteOfAnother() {
        answer((exchange, number) -> {
            if (exchange.getRequestMethod().equals("PUT")) {
                send(exchange, 412, "PreconditionFailed");
                return;
            }
            exchange.getResponseHeaders().set("x-amz-meta-jsm-write", "another");
            stored(exchange);
        });
        assertThatThrownBy(() -> store.put(UPLOAD.withCondition(Condition.ABSENT)))
                .isInstanceOf(ObjectConflictException.class)
                .hasMessageContaining("written by somebody else");
    }

    /** Sends half of what is left, and then nothing. */
    private void answerCut(String tag) {
        answer((exchange, number) -> {
            String range = exchange.getRequestHeaders().getFirst("Range");
            String wanted = exchange.getRequestHeaders().getFirst("If-Match");
            if (wanted != null && !wanted.equals(tag)) {
                send(exchange, 412, "PreconditionFailed");
                return;
            }
            int from = range == null ? 0 : Integer.parseInt(range.replaceAll("bytes=(\\d+)-.*", "$1"));
            int left = CONTENT.length - from;
            exchange.getResponseHeaders().set("ETag", number == 1 ? "\"one\"" : tag);
            if (range != null)
                exchange.getResponseHeaders().set("Content-Range", range.replace('=', ' ') + "/" + CONTENT.length);
            exchange.sendResponseHeaders(range == null ? 200 : 206, left);
            OutputStream out = exchange.getResponseBody();
            out.write(CONTENT, from, (left + 1) / 2);
            out.flush();
        });
    }

    @Test
    void shouldGoOnWhereABodyWasCut() throws Exception {
        answerCut("\"one\"");
        try (InputStream in = store.open("k")) {
            assertThat(in.readAllBytes()).isEqualTo(CONTENT);
        }
        ByteBuffer into = ByteBuffer.allocate(8);
        store.read(new StoredObject("k", CONTENT.length, "\"one\"", Instant.EPOCH), 2, into);
        assertThat(new String(into.array(), UTF_8)).isEqualTo("23456789");
    }

    @Test
    void shouldNotGoOnWithAnotherVersion() throws Exception {
        answerCut("\"two\"");
        try (InputStream in = store.open("k")) {
            assertThatThrownBy(in::readAllBytes).isInstanceOf(ObjectConflictException.class);
        }
    }

    @Test
    void shouldGiveUpBodiesThatAreAlwaysCut() throws Exception {
        answer((exchange, number) -> {
            exchange.getResponseHeaders().set("ETag", "\"one\"");
            exchange.sendResponseHeaders(200, CONTENT.length);
        });
        try (InputStream in = store.open("k")) {
            assertThatThrownBy(in::readAllBytes).isInstanceOf(IOException.class);
        }
        assertThat(asked).hasSize(4);
    }
}
