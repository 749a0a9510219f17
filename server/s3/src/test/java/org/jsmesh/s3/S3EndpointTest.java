package org.jsmesh.s3;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.URI;
import java.nio.file.FileSystemException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class S3EndpointTest {
    @Test
    void shouldTakeAddressesOfServices() {
        for (String address : new String[] {"http://localhost:9000", "https://minio.example/", "HTTP://[::1]:9000"})
            assertThat(S3Clients.endpoint("X", " " + address + " ")).isEqualTo(URI.create(address));
    }

    @ParameterizedTest
    @ValueSource(strings = {"localhost:9000", "localhost", "http://", "ftp://host", "http://a b", "http://a_b:9000"})
    void shouldNameTheSettingThatIsNone(String value) {
        assertThatThrownBy(() -> S3Clients.endpoint("AWS_ENDPOINT_URL_S3", value))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("AWS_ENDPOINT_URL_S3 is '" + value + "'")
                .hasMessageContaining("http://localhost:9000");
    }

    @Test
    void shouldTellOfItAsOfAnyFailure() {
        String before = System.setProperty("aws.endpointUrlS3", "localhost:9000");
        try {
            assertThatThrownBy(() -> S3ObjectStore.at("s3://bucket/p"))
                    .isInstanceOf(FileSystemException.class)
                    .hasMessageStartingWith("s3://bucket/p: aws.endpointUrlS3 is 'localhost:9000'");
        } finally {
            if (before == null) System.clearProperty("aws.endpointUrlS3");
            else System.setProperty("aws.endpointUrlS3", before);
        }
    }
}
