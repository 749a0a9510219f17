package org.jsmesh.s3;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class S3PlaceTest {
    @ParameterizedTest
    @CsvSource({
        "s3://scans, scans, ''",
        "s3://scans/, scans, ''",
        "s3://scans/raw, scans, raw/",
        "s3://scans/raw/2026/, scans, raw/2026/",
        "S3://scans/my models/50%20+, scans, my models/50%20+/",
        "s3://scans/Museum?x#y, scans, Museum?x#y/",
        "s3://scans/größe, scans, größe/"
    })
    void shouldTakeThePrefixAsItIsWrittenAndNameItSo(String address, String bucket, String prefix) {
        S3Place place = S3Place.of(address);
        assertThat(place).isEqualTo(new S3Place(bucket, prefix));
        assertThat(S3Place.of(place.address(""))).isEqualTo(place);
    }

    @ParameterizedTest
    @ValueSource(strings = {"s3://", "s3://ab", "s3:///raw", "s3://scans/a//b", "s3://scans/../b", "s3://user@scans/a"})
    void shouldRefuseWhatIsNoPlace(String address) {
        assertThatThrownBy(() -> S3Place.of(address))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("s3://");
    }
}
