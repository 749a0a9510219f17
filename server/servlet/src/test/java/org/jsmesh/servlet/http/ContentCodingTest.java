package org.jsmesh.servlet.http;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ContentCodingTest {
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "br|1|0",
                "gzip, deflate, br|1|1",
                "GZIP;q=0.5, br ; q=0.25|0.25|0.5",
                "gzip;q=0|0|0",
                "gzip;q=0.000|0|0",
                "gzip;q=7|0|0",
                "gzip;q=high|0|0",
                "brotli, gzipped|0|0",
                "*|1|1",
                "*;q=0.3, gzip|0.3|1",
                "gzip;q=0, *|1|0",
                "''|0|0",
            })
    void shouldWeighAsTheClientSays(String field, double brotli, double gzip) {
        assertThat(ContentCoding.BROTLI.weight(field)).isEqualTo(brotli);
        assertThat(ContentCoding.GZIP.weight(field)).isEqualTo(gzip);
    }

    @ParameterizedTest
    @CsvSource(
            nullValues = "null",
            delimiter = '|',
            value = {"null|true", "gzip|true", "*|true", "identity;q=0|false", "*;q=0|false", "gzip, *;q=0|false"})
    void shouldTakePlainBytesForAcceptedUnlessTheyAreRefused(String field, boolean accepted) {
        assertThat(ContentCoding.IDENTITY.weight(field) > 0).isEqualTo(accepted);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {"gzip;q=0.5, identity;q=0.4", "gzip;q=0.001"})
    void shouldPreferWhatIsNamedToPlainBytes(String field) {
        assertThat(ContentCoding.GZIP.weight(field)).isGreaterThan(ContentCoding.IDENTITY.weight(field));
    }
}
