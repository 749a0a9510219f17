package org.jsmesh.s3;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.ByteBuffer;
import java.nio.file.FileSystemException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.jsmesh.objects.Condition;
import org.jsmesh.objects.ObjectConflictException;
import org.jsmesh.objects.ObjectContent;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.ObjectStores;
import org.jsmesh.objects.StoredObject;
import org.jsmesh.objects.Upload;
import org.jsmesh.s3.testing.S3Mock;
import org.junit.jupiter.api.Test;
import software.amazon.awssdk.services.s3.model.HeadObjectResponse;

class S3ObjectStoreTest extends ObjectStoreContract {
    private static final S3Mock MOCK = S3Mock.shared();

    private final String bucket = MOCK.bucket();

    @Override
    ObjectStore empty() throws IOException {
        return ObjectStores.open("s3://" + bucket + "/some/place/");
    }

    /** The mock looks and writes in two steps. */
    @Override
    StoredObject replace(ObjectStore in, Upload upload) throws IOException {
        synchronized (MOCK) {
            return super.replace(in, upload);
        }
    }

    @Test
    void shouldStayBelowItsPrefix() throws Exception {
        MOCK.client()
                .putObject(
                        b -> b.bucket(bucket).key("some/place2/x"),
                        software.amazon.awssdk.core.sync.RequestBody.fromString("x"));
        MOCK.client()
                .putObject(
                        b -> b.bucket(bucket).key("some/place/folder/"),
                        software.amazon.awssdk.core.sync.RequestBody.fromString(""));
        try (ObjectStore store = empty()) {
            assertThat(store.address()).isEqualTo("s3://" + bucket + "/some/place");
            store.list("", "", object -> {
                throw new AssertionError(object);
            });
            store.put(Upload.of("a", ObjectContent.of(new byte[2])));
            assertThat(MOCK.client()
                            .headObject(b -> b.bucket(bucket).key("some/place/a"))
                            .contentLength())
                    .isEqualTo(2);
        }
    }

    @Test
    void shouldSayWhatItIsAndHowLongItMayBeKept() throws Exception {
        try (ObjectStore store = empty()) {
            store.put(Upload.of("p", ObjectContent.of(new byte[2])).withHeaders("text/html", "no-cache"));
        }
        HeadObjectResponse head = MOCK.client().headObject(b -> b.bucket(bucket).key("some/place/p"));
        assertThat(head.contentType()).isEqualTo("text/html");
        assertThat(head.cacheControl()).isEqualTo("no-cache");
    }

    @Test
    void shouldWriteLargeObjectsInParts() throws Exception {
        byte[] content = new byte[11 << 20];
        new Random(5).nextBytes(content);
        Upload upload = Upload.of("large", ObjectContent.of(content)).withHeaders("model/x", "max-age=1");
        try (ObjectStore store = new S3ObjectStore(S3Clients.client(null), place(), 6 << 20, 5 << 20, 1000)) {
            StoredObject object = store.put(upload.withCondition(Condition.ABSENT));
            assertThat(object.bytes()).isEqualTo(content.length);
            assertThat(object.tag()).contains("-3");
            ByteBuffer read = ByteBuffer.allocate(content.length);
            store.read(object, 0, read);
            assertThat(read.array()).isEqualTo(content);
            assertThat(MOCK.client()
                            .headObject(b -> b.bucket(bucket).key("some/place/large"))
                            .contentType())
                    .isEqualTo("model/x");
            assertThatThrownBy(() -> store.put(upload.withCondition(Condition.ABSENT)))
                    .isInstanceOf(ObjectConflictException.class);
            assertThat(MOCK.client().listMultipartUploads(b -> b.bucket(bucket)).uploads())
                    .as("left over")
                    .isEmpty();
        }
    }

    private S3Place place() {
        return S3Place.of("s3://" + bucket + "/some/place");
    }

    @Test
    void shouldTellWhenContentCannotBeRead() throws Exception {
        ObjectContent content = new ObjectContent() {
            @Override
            public long bytes() {
                return 5;
            }

            @Override
            public InputStream open() throws IOException {
                throw new FileSystemException("source", null, "is gone");
            }
        };
        try (ObjectStore store = empty()) {
            assertThatThrownBy(() -> store.put(Upload.of("a", content)))
                    .isInstanceOf(FileSystemException.class)
                    .hasMessage("source: is gone");
            assertThat(store.find("a")).isEmpty();
        }
    }

    @Test
    void shouldListMoreThanAPage() throws Exception {
        try (ObjectStore store = new S3ObjectStore(S3Clients.client(null), place(), 1 << 20, 1 << 20, 4)) {
            for (int i = 0; i < 11; i++) store.put(Upload.of(String.format("k%02d", i), ObjectContent.of(new byte[1])));
            List<String> keys = new ArrayList<>();
            store.list("k", "k01", object -> keys.add(object.key()));
            assertThat(keys).hasSize(9).startsWith("k02").endsWith("k10");
        }
    }

    @Test
    void shouldSignAddressesThatAnybodyCanRead() throws Exception {
        try (ObjectStore store = empty()) {
            store.put(Upload.of("a b", ObjectContent.of(new byte[] {1, 2, 3})));
            URI address = store.signedAddress("a b", Duration.ofMinutes(5)).orElseThrow();
            assertThat(address.getQuery()).contains("X-Amz-Signature=", "X-Amz-Expires=300");
            byte[] body = HttpClient.newHttpClient()
                    .send(
                            HttpRequest.newBuilder(address)
                                    .header("Range", "bytes=1-")
                                    .build(),
                            BodyHandlers.ofByteArray())
                    .body();
            assertThat(body).containsExactly(2, 3);
        }
    }

    @Test
    void shouldTellOfABucketThatIsNotThere() throws Exception {
        try (ObjectStore store = ObjectStores.open("s3://no-such-bucket-here/x")) {
            assertThatThrownBy(() -> store.put(Upload.of("a", ObjectContent.of(new byte[1]))))
                    .isInstanceOf(FileSystemException.class)
                    .hasMessage("s3://no-such-bucket-here/x/a: there is no such bucket."
                            + " Check its name and the endpoint, or make it first");
            assertThatThrownBy(() -> store.list("", "", object -> true)).hasMessageContaining("no such bucket");
        }
    }

    @Test
    void shouldRefuseAddressesThatAreNone() {
        for (String address : List.of("s3:///x", "s3://b", "s3://bucket/a//b", "s3://bucket/../x"))
            assertThatThrownBy(() -> ObjectStores.open(address))
                    .as(address)
                    .isInstanceOf(IllegalArgumentException.class);
    }
}
