package org.jsmesh.s3;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.file.FileSystemException;
import java.time.Instant;
import org.jsmesh.objects.Condition;
import org.jsmesh.objects.ObjectConflictException;
import org.jsmesh.objects.ObjectContent;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;
import org.jsmesh.objects.Upload;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A service, or something before it, whose answers lack what is relied on. */
class S3AnswersTest {
    private static final byte[] CONTENT = "0123456789".getBytes(UTF_8);
    private static final StoredObject OBJECT = new StoredObject("k", CONTENT.length, "\"one\"", Instant.EPOCH);
    private static final Upload UPLOAD = Upload.of("k", ObjectContent.of(CONTENT));

    private static void whole(HttpExchange exchange) throws IOException {
        exchange.getResponseHeaders().set("ETag", "\"one\"");
        exchange.sendResponseHeaders(200, CONTENT.length);
        exchange.getResponseBody().write(CONTENT);
    }

    private static void half(HttpExchange exchange) throws IOException {
        exchange.sendResponseHeaders(200, CONTENT.length);
        exchange.getResponseBody().write(CONTENT, 0, 5);
        exchange.getResponseBody().flush();
    }

    @Test
    void shouldNotTakeTheWholeForAPart() throws Exception {
        try (FakeService service = new FakeService((exchange, number) -> whole(exchange));
                ObjectStore store = service.store()) {
            assertThatThrownBy(() -> store.read(OBJECT, 2, ByteBuffer.allocate(8)))
                    .isInstanceOf(FileSystemException.class)
                    .hasMessage("s3://bucket/p/k: the service does not send parts of objects (Range)."
                            + " Check what stands between here and the service, or use another service");
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"bytes 0-7/10", "bytes 2-8/10", "bytes 02-9/10", "bytes */10"})
    void shouldNotTakeAnotherPart(String range) throws Exception {
        try (FakeService service = new FakeService((exchange, number) -> {
                    exchange.getResponseHeaders().set("Content-Range", range);
                    exchange.getResponseHeaders().set("ETag", "\"one\"");
                    exchange.sendResponseHeaders(206, 8);
                    exchange.getResponseBody().write(CONTENT, 0, 8);
                });
                ObjectStore store = service.store()) {
            assertThatThrownBy(() -> store.read(OBJECT, 2, ByteBuffer.allocate(8)))
                    .isInstanceOf(FileSystemException.class)
                    .hasMessageContaining("another part than bytes 2 to 9 (" + range + ")");
        }
    }

    @Test
    void shouldNotGoOnWithTheWholeWhereABodyWasCut() throws Exception {
        try (FakeService service = new FakeService((exchange, number) -> {
                    exchange.getResponseHeaders().set("ETag", "\"one\"");
                    if (number == 1) half(exchange);
                    else whole(exchange);
                });
                ObjectStore store = service.store();
                InputStream in = store.open("k")) {
            assertThatThrownBy(in::readAllBytes)
                    .isInstanceOf(FileSystemException.class)
                    .hasMessageContaining("does not send parts");
        }
    }

    @Test
    void shouldNotGoOnWithoutKnowingTheVersion() throws Exception {
        try (FakeService service = new FakeService((exchange, number) -> half(exchange));
                ObjectStore store = service.store();
                InputStream in = store.open("k")) {
            assertThatThrownBy(in::readAllBytes).isInstanceOf(IOException.class);
            assertThat(service.asked()).containsExactly("GET");
        }
    }

    @Test
    void shouldTellWhatIsMissingOfAnObject() throws Exception {
        try (FakeService service = new FakeService((exchange, number) -> {
                    if (number != 2) exchange.getResponseHeaders().set("Content-Length", "10");
                    if (number != 1) exchange.getResponseHeaders().set("ETag", "\"one\"");
                    exchange.sendResponseHeaders(200, -1);
                });
                ObjectStore store = service.store()) {
            assertThatThrownBy(() -> store.find("k"))
                    .isInstanceOf(FileSystemException.class)
                    .hasMessageContaining("s3://bucket/p/k: the service tells no version (ETag)");
            assertThatThrownBy(() -> store.find("k"))
                    .isInstanceOf(FileSystemException.class)
                    .hasMessageContaining("s3://bucket/p/k: the service tells no length");
            assertThat(store.find("k")).contains(OBJECT);
        }
    }

    @Test
    void shouldTellWhenAWriteGetsNoVersion() throws Exception {
        try (FakeService service = new FakeService((exchange, number) -> exchange.sendResponseHeaders(200, -1));
                ObjectStore store = service.store()) {
            assertThatThrownBy(() -> store.put(UPLOAD.withCondition(Condition.ABSENT)))
                    .isInstanceOf(FileSystemException.class)
                    .hasMessageContaining("the service tells no version");
        }
    }

    @Test
    void shouldTryAgainWhereAnUnconditionalWriteMeetsAnother() throws Exception {
        try (FakeService service = new FakeService((exchange, number) -> {
                    boolean isPut = exchange.getRequestMethod().equals("PUT");
                    if (isPut && number == 1) FakeService.fail(exchange, 409, "OperationAborted");
                    else if (isPut) {
                        exchange.getResponseHeaders().set("ETag", "\"new\"");
                        exchange.sendResponseHeaders(200, -1);
                    } else FakeService.fail(exchange, 404, "NoSuchKey");
                });
                ObjectStore store = service.store()) {
            assertThat(store.put(UPLOAD).tag()).isEqualTo("\"new\"");
            assertThat(service.asked()).containsExactly("PUT", "HEAD", "PUT");
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {409, 412})
    void shouldBlameNobodyElseForAnUnconditionalWrite(int status) throws Exception {
        try (FakeService service = new FakeService((exchange, number) -> {
                    if (exchange.getRequestMethod().equals("PUT")) FakeService.fail(exchange, status, "Odd");
                    else FakeService.fail(exchange, 404, "NoSuchKey");
                });
                ObjectStore store = service.store()) {
            assertThatThrownBy(() -> store.put(UPLOAD))
                    .isInstanceOf(FileSystemException.class)
                    .isNotInstanceOf(ObjectConflictException.class)
                    .hasMessageContaining(status + " Odd");
            assertThat(service.asked().stream().filter("PUT"::equals)).hasSize(status == 409 ? 2 : 1);
        }
    }
}
