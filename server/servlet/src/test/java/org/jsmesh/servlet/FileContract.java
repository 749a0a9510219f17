package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.servlet.testing.RawHttp;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * What every container has to answer to those who ask for the archive as a file: ranges, conditions and methods of
 * HTTP.
 */
abstract class FileContract extends ContractServer {
    @Test
    void shouldSendTheWholeArchiveWithHeadersForCaches() throws Exception {
        HttpResponse<byte[]> answer = get(archiveUrl(), "Accept-Encoding", "gzip");
        assertThat(answer.statusCode()).isEqualTo(200);
        assertThat(answer.body()).isEqualTo(ARCHIVE);
        assertThat(header(answer, "Cache-Control")).isEqualTo("public, max-age=31536000, immutable, no-transform");
        assertThat(header(answer, "ETag")).isEqualTo('"' + sha256 + '"');
        assertThat(header(answer, "Accept-Ranges")).isEqualTo("bytes");
        assertThat(header(answer, "Content-Length")).isEqualTo("10500");
        assertThat(header(answer, "Content-Type")).isEqualTo("model/vnd.jsm");
        assertThat(answer.headers().firstValue("Content-Encoding")).isEmpty();
        assertThat(header(answer, "Server-Timing")).matches("prepare;dur=\\d+\\.\\d{3}");
        assertThat(header(answer, "Timing-Allow-Origin")).isEqualTo("*");
        assertThat(header(answer, "Cross-Origin-Resource-Policy")).isEqualTo("cross-origin");
        assertThat(header(answer, "Access-Control-Allow-Origin")).isEqualTo("*");
        assertThat(header(answer, "Access-Control-Expose-Headers"))
                .contains("Content-Range", "ETag", "Retry-After", "Server-Timing");
        assertThat(header(answer, "X-Content-Type-Options")).isEqualTo("nosniff");
    }

    @ParameterizedTest
    @CsvSource({
        "bytes=0-0, 0, 1",
        "bytes=0-999, 0, 1000",
        "bytes=1500-3499, 1500, 3500",
        "bytes=10000-, 10000, 10500",
        "bytes=10000-99999, 10000, 10500",
        "bytes=-1, 10499, 10500",
        "bytes=-99999, 0, 10500"
    })
    void shouldSendOneRange(String range, int from, int to) throws Exception {
        HttpResponse<byte[]> answer = get(archiveUrl(), "Range", range);
        assertThat(answer.statusCode()).isEqualTo(206);
        assertThat(answer.body()).isEqualTo(Arrays.copyOfRange(ARCHIVE, from, to));
        assertThat(header(answer, "Content-Range")).isEqualTo("bytes " + from + "-" + (to - 1) + "/10500");
        assertThat(header(answer, "Content-Length")).isEqualTo(Integer.toString(to - from));
        assertThat(header(answer, "ETag")).isEqualTo('"' + sha256 + '"');
    }

    @ParameterizedTest
    @ValueSource(strings = {"bytes=0-1,5-6", "bytes=5-4", "bytes=x", "lines=1-2"})
    void shouldSendTheWholeForOtherRanges(String range) throws Exception {
        HttpResponse<byte[]> answer = get(archiveUrl(), "Range", range);
        assertThat(answer.statusCode()).isEqualTo(200);
        assertThat(answer.body()).isEqualTo(ARCHIVE);
        assertThat(answer.headers().firstValue("Content-Range")).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"bytes=10500-", "bytes=20000-30000", "bytes=-0"})
    void shouldRefuseRangesBehindTheEnd(String range) throws Exception {
        HttpResponse<byte[]> answer = get(archiveUrl(), "Range", range);
        assertThat(answer.statusCode()).isEqualTo(416);
        assertThat(header(answer, "Content-Range")).isEqualTo("bytes */10500");
        assertError(answer);
    }

    @Test
    void shouldHonourIfRangeOnlyForTheSameArchive() throws Exception {
        String tag = '"' + sha256 + '"';
        assertThat(get(archiveUrl(), "Range", "bytes=5-9", "If-Range", tag).statusCode())
                .isEqualTo(206);
        assertThat(get(archiveUrl(), "Range", "bytes=5-9", "If-Range", "W/" + tag)
                        .statusCode())
                .isEqualTo(200);
        assertThat(get(archiveUrl(), "Range", "bytes=5-9", "If-Range", "\"other\"")
                        .statusCode())
                .isEqualTo(200);
        String date = "Sat, 29 Oct 2044 19:43:31 GMT";
        assertThat(get(archiveUrl(), "Range", "bytes=5-9", "If-Range", date).body())
                .isEqualTo(ARCHIVE);
    }

    @Test
    void shouldAnswerConditionalRequests() throws Exception {
        String tag = '"' + sha256 + '"';
        for (String field : List.of(tag, "W/" + tag, "\"a\", " + tag, "*")) {
            HttpResponse<byte[]> answer = get(archiveUrl(), "If-None-Match", field, "Range", "bytes=0-9");
            assertThat(answer.statusCode()).as(field).isEqualTo(304);
            assertThat(header(answer, "ETag")).isEqualTo(tag);
            assertThat(answer.body()).isEmpty();
        }
        assertThat(get(archiveUrl(), "If-None-Match", "\"other\"").statusCode()).isEqualTo(200);
    }

    @Test
    void shouldAnswerHeadWithoutABody() throws Exception {
        HttpRequest head = request(archiveUrl(), "Range", "bytes=0-9")
                .method("HEAD", HttpRequest.BodyPublishers.noBody())
                .build();
        HttpResponse<byte[]> answer = client.send(head, HttpResponse.BodyHandlers.ofByteArray());
        assertThat(answer.statusCode()).as("a range is defined for GET only").isEqualTo(200);
        assertThat(header(answer, "Content-Length")).isEqualTo("10500");
        assertThat(header(answer, "Accept-Ranges")).isEqualTo("bytes");
        assertThat(answer.body()).isEmpty();
    }

    @Test
    void shouldLetPagesFromElsewhereAskForRanges() throws Exception {
        HttpRequest preflight = request(
                        archiveUrl(),
                        "Origin",
                        "https://example.org",
                        "Access-Control-Request-Headers",
                        "if-range,range")
                .method("OPTIONS", HttpRequest.BodyPublishers.noBody())
                .build();
        HttpResponse<byte[]> answer = client.send(preflight, HttpResponse.BodyHandlers.ofByteArray());
        assertThat(answer.statusCode()).isEqualTo(204);
        assertThat(header(answer, "Access-Control-Allow-Origin")).isEqualTo("*");
        assertThat(header(answer, "Access-Control-Allow-Headers")).contains("Range", "If-Range");
    }

    @ParameterizedTest
    @ValueSource(strings = {"m/bunny", "m/", "m/nothing.html"})
    void shouldRefuseOtherMethods(String path) throws Exception {
        for (String method : List.of("POST", "PUT", "DELETE", "PATCH")) {
            HttpRequest request = request(path)
                    .method(method, HttpRequest.BodyPublishers.ofString("x"))
                    .build();
            HttpResponse<byte[]> answer = client.send(request, HttpResponse.BodyHandlers.ofByteArray());
            assertThat(answer.statusCode()).isEqualTo(405);
            assertThat(header(answer, "Allow")).isEqualTo("GET, HEAD, OPTIONS");
            assertError(answer);
        }
    }

    /** Containers leave parameters out of the path that they hand on; each would be another address of one resource. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "/m/bunny;x=y/manifest.json",
                "/m/bunny/manifest.json;x",
                "/m/bunny/manifest.json;",
                "/m;x=y/bunny/manifest.json",
                "/m/;x/bunny/manifest.json",
                "/m/bunny%3bx=y/manifest.json",
                "/m/bunny%2fmanifest.json",
                "/m/bunny%2Fmanifest.json",
                "/m/bunny%5cmanifest.json",
                "/m/bunny%252fmanifest.json",
                "/m/index.json;jsessionid=1"
            })
    void shouldRefuseOtherAddressesOfAResource(String target) throws Exception {
        assertThat(RawHttp.get(server.root(), target)).matches("(?s)HTTP/1\\.1 40[04].*");
        assertThat(RawHttp.get(server.root(), "/m/%62unny/manifest.json")).startsWith("HTTP/1.1 200");
    }
}
