package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.servlet.http.Digests;
import org.jsmesh.store.TestArchives;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Conditional requests (RFC 9110, section 13) for everything that has an entity tag. */
abstract class ConditionalContract extends ContractServer {
    private static final byte[] SHOWN = TestArchives.shown(9, 1000, 500, 2000);

    @BeforeEach
    void addModelWithPoster() throws Exception {
        Files.write(folder.resolve("shown.jsm"), SHOWN);
        store.list(); // looks at once
    }

    private HttpResponse<byte[]> ask(String method, String path, String... headers) throws Exception {
        String address = path.replace("SHA", Digests.sha256(SHOWN));
        HttpRequest request = request(address, headers)
                .method(method, HttpRequest.BodyPublishers.noBody())
                .build();
        return client.send(request, HttpResponse.BodyHandlers.ofByteArray());
    }

    private int status(String path, String... headers) throws Exception {
        int status = ask("GET", path, headers).statusCode();
        HttpResponse<byte[]> head = ask("HEAD", path, headers);
        assertThat(head.statusCode()).isEqualTo(status);
        assertThat(head.body()).isEmpty();
        return status;
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "m/shown/SHA.jsm",
                "m/shown/SHA/batches/0-1",
                "m/shown/SHA/first.jsm",
                "m/shown/SHA/poster.jpg",
                "m/shown/manifest.json",
                "m/shown/",
                "m/index.json",
                "m/",
            })
    void shouldKeepToTheConditionsOfRequests(String path) throws Exception {
        HttpResponse<byte[]> whole = ask("GET", path);
        assertThat(whole.statusCode()).isEqualTo(200);
        assertThat(whole.headers().firstValue("Last-Modified")).isEmpty();
        String tag = header(whole, "ETag");
        assertThat(tag).matches("\"[^\",]+\"");
        String date = "Sun, 06 Nov 1994 08:49:37 GMT";
        String later = "Sun, 06 Nov 2094 08:49:37 GMT";

        assertThat(status(path, "If-Match", tag)).isEqualTo(200);
        assertThat(status(path, "If-Match", "*")).isEqualTo(200);
        assertThat(status(path, "If-Match", "\"a\", " + tag)).isEqualTo(200);
        assertThat(status(path, "If-Match", "\"a\"", "If-Match", tag)).isEqualTo(200);
        assertThat(status(path, "If-Match", "\"a\"")).isEqualTo(412);
        assertThat(status(path, "If-Match", "\"a\"", "If-Match", "\"b\"")).isEqualTo(412);
        assertThat(status(path, "If-Match", "W/" + tag)).as("not strong").isEqualTo(412);

        assertThat(status(path, "If-None-Match", tag)).isEqualTo(304);
        assertThat(status(path, "If-None-Match", "W/" + tag)).isEqualTo(304);
        assertThat(status(path, "If-None-Match", "*")).isEqualTo(304);
        assertThat(status(path, "If-None-Match", "\"a\" , " + tag)).isEqualTo(304);
        assertThat(status(path, "If-None-Match", "\"a\"", "If-None-Match", tag)).isEqualTo(304);
        assertThat(status(path, "If-None-Match", "\"a\"", "If-None-Match", "\"b\""))
                .isEqualTo(200);

        assertThat(status(path, "If-Match", "\"a\"", "If-None-Match", tag)).isEqualTo(412);
        assertThat(status(path, "If-Match", tag, "If-None-Match", tag)).isEqualTo(304);
        // There is no date to compare with.
        assertThat(status(path, "If-Modified-Since", later)).isEqualTo(200);
        assertThat(status(path, "If-Unmodified-Since", date)).isEqualTo(200);
        assertThat(status(path, "If-None-Match", "\"a\"", "If-Modified-Since", later))
                .isEqualTo(200);
    }

    @ParameterizedTest
    @ValueSource(strings = {"m/shown/SHA.jsm", "m/index.json"})
    void shouldSayWhatItHasWithAnswersWithoutABody(String path) throws Exception {
        String tag = header(ask("GET", path), "ETag");
        for (String method : List.of("GET", "HEAD")) {
            HttpResponse<byte[]> unchanged = ask(method, path, "If-None-Match", tag);
            assertThat(unchanged.body()).isEmpty();
            assertThat(header(unchanged, "ETag")).isEqualTo(tag);
            assertThat(unchanged.headers().firstValue("Cache-Control")).isPresent();
        }
        HttpResponse<byte[]> failed = ask("GET", path, "If-Match", "\"a\"");
        assertError(failed);
        assertThat(failed.headers().firstValue("ETag")).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"\"a\"", "W/TAG", "Sun, 06 Nov 2094 08:49:37 GMT"})
    void shouldSendTheWholeWhereTheRangeIsOfSomethingElse(String condition) throws Exception {
        String path = "m/shown/SHA.jsm";
        String tag = header(ask("GET", path), "ETag");
        String same = condition.replace("TAG", tag);
        assertThat(ask("GET", path, "Range", "bytes=0-9", "If-Range", same).statusCode())
                .isEqualTo(200);
        assertThat(ask("GET", path, "Range", "bytes=0-9", "If-Range", tag).statusCode())
                .isEqualTo(206);
        List<String> all = new ArrayList<>(List.of("Range", "bytes=0-9", "If-Range", tag, "If-None-Match", tag));
        assertThat(ask("GET", path, all.toArray(String[]::new)).statusCode()).isEqualTo(304);
        all.addAll(List.of("If-Match", "\"a\""));
        assertThat(ask("GET", path, all.toArray(String[]::new)).statusCode()).isEqualTo(412);
    }

    @ParameterizedTest
    @ValueSource(strings = {"m/nobody/manifest.json", "m/shown/SHA/batches/7-9"})
    void shouldSayThatNothingIsThereWhateverTheCondition(String path) throws Exception {
        assertThat(status(path, "If-Match", "*")).isEqualTo(404);
        assertThat(status(path, "If-None-Match", "*")).isEqualTo(404);
    }
}
