package org.jsmesh.s3;

import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.nio.ByteBuffer;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.time.Duration;
import java.util.Optional;
import org.jsmesh.objects.ObjectConflictException;
import org.jsmesh.objects.ObjectKeys;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;
import org.jsmesh.objects.Upload;
import software.amazon.awssdk.core.exception.SdkClientException;
import software.amazon.awssdk.core.exception.SdkException;
import software.amazon.awssdk.services.s3.S3Client;
import software.amazon.awssdk.services.s3.model.EncodingType;
import software.amazon.awssdk.services.s3.model.HeadObjectResponse;
import software.amazon.awssdk.services.s3.model.ListObjectsV2Response;
import software.amazon.awssdk.services.s3.model.S3Object;

/**
 * The objects of a bucket whose keys begin with a prefix. Conditions are the service's own, so that they hold among all
 * who write. Throttled and failed requests are tried again by the SDK. Thread-safe.
 */
public final class S3ObjectStore implements ObjectStore {
    private static final long MOST_IN_ONE = 64L << 20;
    private static final long LEAST_PART = 16L << 20;
    private static final int PAGE = 1000;
    private static final Duration ASK_AGAIN = Duration.ofSeconds(30);

    private final S3Client client;
    private final S3Place place;
    private final S3Writer writer;
    private final int pageSize;
    private final S3Signer signer;

    S3ObjectStore(S3Client client, S3Place place, long mostInOne, long leastPart, int pageSize) {
        this.client = client;
        this.place = place;
        this.pageSize = pageSize;
        writer = new S3Writer(client, place, mostInOne, leastPart);
        signer = new S3Signer(client, place.bucket(), ASK_AGAIN);
    }

    /**
     * Opens a part of a bucket, with the credentials, region and endpoint that the AWS SDK is told. Nothing is asked of
     * the service yet.
     *
     * @param address {@code s3://bucket} or {@code s3://bucket/prefix}
     * @return the store, to be closed
     * @throws IllegalArgumentException when the address is another
     * @throws IOException when the settings cannot be used
     */
    public static S3ObjectStore at(String address) throws IOException {
        return at(address, null);
    }

    /**
     * Opens a part of a bucket for somebody who waits.
     *
     * @param address {@code s3://bucket} or {@code s3://bucket/prefix}
     * @param patience how long an answer may take with what is tried again, and three times as long as the service may
     *     be silent in one; at least 3 ms, or null for as long as may help
     * @return the store, to be closed
     * @throws IllegalArgumentException when the address is another
     * @throws IOException when the settings cannot be used
     */
    public static S3ObjectStore at(String address, Duration patience) throws IOException {
        S3Place place = S3Place.of(address);
        try {
            return new S3ObjectStore(S3Clients.client(patience), place, MOST_IN_ONE, LEAST_PART, PAGE);
        } catch (SdkException e) {
            throw S3Failures.of(e, place.address(""), "s3:ListBucket");
        } catch (IllegalArgumentException e) {
            throw (IOException) new FileSystemException(place.address(""), null, e.getMessage()).initCause(e);
        }
    }

    @Override
    public String address() {
        return place.address("");
    }

    @Override
    public Optional<StoredObject> find(String key) throws IOException {
        String whole = place.key(key);
        try {
            HeadObjectResponse head =
                    client.headObject(b -> b.bucket(place.bucket()).key(whole));
            return Optional.of(S3Answers.object(place, key, head.contentLength(), head.eTag(), head.lastModified()));
        } catch (SdkException e) {
            // HEAD has no body that would tell a missing object from a missing bucket; the next listing or write does.
            IOException failure = S3Failures.of(e, place.address(key), "s3:GetObject");
            if (failure instanceof NoSuchFileException) return Optional.empty();
            throw failure;
        }
    }

    @Override
    public InputStream open(String key) throws IOException {
        return new S3Stream(client, place, key, null, 0, -1);
    }

    @Override
    public void read(StoredObject object, long offset, ByteBuffer into) throws IOException {
        if (!into.hasRemaining()) return;
        if (offset + into.remaining() > object.bytes())
            throw new ObjectConflictException(place.address(object.key()), "is shorter than what is read of it");
        try (InputStream in = new S3Stream(client, place, object.key(), object.tag(), offset, into.remaining())) {
            if (into.hasArray()) {
                int count = in.readNBytes(into.array(), into.arrayOffset() + into.position(), into.remaining());
                into.position(into.position() + count);
            } else {
                byte[] piece = new byte[Math.min(into.remaining(), 1 << 16)];
                for (int count; (count = in.read(piece)) > 0; ) into.put(piece, 0, count);
            }
        }
    }

    @Override
    public StoredObject put(Upload upload) throws IOException {
        return writer.write(upload);
    }

    @Override
    public void delete(String key) throws IOException {
        String whole = place.key(key);
        try {
            client.deleteObject(b -> b.bucket(place.bucket()).key(whole));
        } catch (SdkException e) {
            IOException failure = S3Failures.of(e, place.address(key), "s3:DeleteObject");
            if (!(failure instanceof NoSuchFileException)) throw failure;
        }
    }

    @Override
    public void list(String prefix, String after, Visitor visitor) throws IOException {
        String from = after.isEmpty() ? null : place.prefix() + after;
        String token = null;
        do {
            ListObjectsV2Response page = page(place.prefix() + prefix, from, token);
            for (S3Object found : page.contents()) {
                String key = found.key().substring(place.prefix().length());
                if (!ObjectKeys.isKey(key)) {
                    if (!key.isEmpty() && !key.endsWith("/")) visitor.unnameable(key, unnameable(key));
                    continue;
                }
                StoredObject object = S3Answers.object(place, key, found.size(), found.eTag(), found.lastModified());
                if (!visitor.visit(object)) return;
            }
            token = Boolean.TRUE.equals(page.isTruncated())
                    ? S3Answers.next(place, token, page.nextContinuationToken())
                    : null;
        } while (token != null);
    }

    private FileSystemException unnameable(String key) {
        return new FileSystemException(
                place.address(key),
                null,
                "has a name that is not the same everywhere. Give it one without empty names, '.' and '..' between"
                        + " slashes, without backslashes and control characters, of at most 1024 bytes");
    }

    private ListObjectsV2Response page(String prefix, String after, String token) throws IOException {
        try {
            return client.listObjectsV2(b -> {
                b.bucket(place.bucket()).prefix(prefix).maxKeys(pageSize);
                b.encodingType(EncodingType.URL); // XML cannot hold all characters of keys.
                if (token == null) b.startAfter(after);
                else b.continuationToken(token);
            });
        } catch (SdkException e) {
            throw S3Failures.of(e, place.address(""), "s3:ListBucket");
        }
    }

    @Override
    public Optional<URI> signedAddress(String key, Duration lifetime) {
        String whole = place.key(key);
        try {
            return Optional.of(signer.sign(whole, lifetime));
        } catch (SdkClientException e) {
            return Optional.empty(); // Without credentials nothing can be signed; reading tells of it.
        }
    }

    @Override
    public void close() {
        signer.close();
        client.close();
    }
}
