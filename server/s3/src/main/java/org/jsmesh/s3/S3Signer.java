package org.jsmesh.s3;

import java.net.URI;
import java.time.Duration;
import software.amazon.awssdk.regions.Region;
import software.amazon.awssdk.services.s3.S3Client;
import software.amazon.awssdk.services.s3.presigner.S3Presigner;

/** Signs addresses for the region that the bucket is in. Thread-safe. */
final class S3Signer implements AutoCloseable {
    private final S3Client client;
    private final String bucket;
    private final Duration pause;
    private S3Presigner presigner; // made when the first address is wanted
    private boolean isCertain;
    private long asked;

    /** @param pause before a service that failed to tell the region is asked again; all who sign wait for its answer */
    S3Signer(S3Client client, String bucket, Duration pause) {
        this.client = client;
        this.bucket = bucket;
        this.pause = pause;
    }

    /** @throws software.amazon.awssdk.core.exception.SdkClientException when there are no credentials */
    URI sign(String key, Duration lifetime) {
        return URI.create(presigner()
                .presignGetObject(b -> b.signatureDuration(lifetime)
                        .getObjectRequest(g -> g.bucket(bucket).key(key)))
                .url()
                .toString());
    }

    private synchronized S3Presigner presigner() {
        if (presigner != null && (isCertain || System.nanoTime() - asked < pause.toNanos())) return presigner;
        Region told = S3Clients.regionOf(client, bucket);
        isCertain = told != null;
        asked = System.nanoTime();
        // One that it takes the place of is not closed, as others may be signing with it. It holds no connection.
        presigner = S3Clients.presigner(client, told);
        return presigner;
    }

    @Override
    public synchronized void close() {
        if (presigner != null) presigner.close();
    }
}
