package org.jsmesh.s3;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Amazon's service tells the region of a bucket, if it tells anything. */
class S3SignerTest {
    private static final Duration LIFETIME = Duration.ofMinutes(5);

    private final Map<String, String> before = new HashMap<>();

    @BeforeEach
    void set() {
        set("aws.endpointUrlS3", null);
        set("aws.region", "us-west-2");
        set("aws.accessKeyId", "a");
        set("aws.secretAccessKey", "b");
    }

    private void set(String name, String value) {
        before.put(name, System.getProperty(name));
        put(name, value);
    }

    private static void put(String name, String value) {
        if (value == null) System.clearProperty(name);
        else System.setProperty(name, value);
    }

    @AfterEach
    void reset() {
        before.forEach(S3SignerTest::put);
    }

    private static String signed(S3Signer signer) {
        return signer.sign("k", LIFETIME).getQuery();
    }

    @Test
    void shouldSignForTheRegionThatARefusalTells() throws Exception {
        try (FakeService service = new FakeService((exchange, number) -> {
                    exchange.getResponseHeaders().set("x-amz-bucket-region", "eu-south-1");
                    FakeService.fail(exchange, 403, "AccessDenied");
                });
                S3Signer signer = new S3Signer(service.client(), "bucket", Duration.ZERO)) {
            assertThat(signed(signer)).contains("/eu-south-1/s3/");
            assertThat(signed(signer)).contains("/eu-south-1/s3/");
            assertThat(service.asked()).hasSize(1);
        }
    }

    @Test
    void shouldSignForTheRegionThatIsSetWhereARefusalTellsNone() throws Exception {
        try (FakeService service =
                        new FakeService((exchange, number) -> FakeService.fail(exchange, 403, "AccessDenied"));
                S3Signer signer = new S3Signer(service.client(), "bucket", Duration.ZERO)) {
            assertThat(signed(signer)).contains("/us-west-2/s3/");
            assertThat(signed(signer)).contains("/us-west-2/s3/");
            assertThat(service.asked()).hasSize(1);
        }
    }

    @Test
    void shouldAskAgainAfterAFailure() throws Exception {
        boolean[] isWell = {false};
        try (FakeService service = new FakeService((exchange, number) -> {
                    if (isWell[0]) exchange.getResponseHeaders().set("x-amz-bucket-region", "eu-south-1");
                    FakeService.fail(exchange, isWell[0] ? 200 : 503, "SlowDown");
                });
                S3Signer patient = new S3Signer(service.client(), "bucket", Duration.ofHours(1));
                S3Signer signer = new S3Signer(service.client(), "bucket", Duration.ZERO)) {
            assertThat(signed(patient)).contains("/us-west-2/s3/");
            assertThat(signed(signer)).contains("/us-west-2/s3/");
            int asked = service.asked().size();
            isWell[0] = true;
            assertThat(signed(patient)).contains("/us-west-2/s3/");
            assertThat(service.asked()).hasSize(asked);
            assertThat(signed(signer)).contains("/eu-south-1/s3/");
        }
    }
}
