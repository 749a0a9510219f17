package org.jsmesh.servlet.http;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Addresses that all who pass them on understand alike. */
class PlainPathTest {
    @ParameterizedTest
    @ValueSource(
            strings = {"/", "/m/bunny/manifest.json", "/m/%E6%A4%85-obj-abcdef/", "/m/%e6%a4%85", "/m/%62", "/m/a%20b"})
    void shouldTakePlainPaths(String path) {
        assertThat(PlainPath.isPlain(path)).isTrue();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "/m/bunny;x=y",
                "/;",
                "/m\\bunny",
                "/m/%2f",
                "/m/%2F",
                "/m/%5C",
                "/m/%3b",
                "/m/%25",
                "/m/%00",
                "/m/%0a",
                "/m/%7f",
                "/m/%",
                "/m/%4",
                "/m/%zz",
                "/m/%4z",
                "/m/%u0041"
            })
    void shouldRefuseAllOthers(String path) {
        assertThat(PlainPath.isPlain(path)).isFalse();
    }
}
