package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.ByteArrayInputStream;
import java.net.URI;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.util.Arrays;
import java.util.List;
import java.util.zip.GZIPInputStream;
import org.jsmesh.servlet.testing.RawHttp;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What every container has to answer, over real connections. */
abstract class ProtocolContract extends FileContract {
    @Test
    void shouldListModels() throws Exception {
        Files.writeString(folder.resolve("horse.ply"), "horse");
        store.list(); // looks at once
        get("m/bunny/manifest.json");
        HttpResponse<byte[]> answer = get("m/");
        assertThat(answer.statusCode()).isEqualTo(200);
        assertThat(header(answer, "Content-Type")).startsWith("application/json");
        assertThat(answer.headers().allValues("Vary")).contains("Accept", "Accept-Encoding");
        JsonNode models = JSON.readTree(answer.body()).get("models");
        assertThat(models).hasSize(2);
        JsonNode bunny = models.get(0);
        assertThat(bunny.get("id").asText()).isEqualTo("bunny");
        assertThat(bunny.get("name").asText()).isEqualTo("Bunny");
        assertThat(bunny.get("state").asText()).isEqualTo("ready");
        assertThat(bunny.get("faces").asInt()).isEqualTo(700);
        assertThat(bunny.get("bytes").asLong()).isEqualTo(ARCHIVE.length);
        assertThat(get("m/" + bunny.get("manifestUrl").asText()).statusCode()).isEqualTo(200);
        assertThat(get("m/" + bunny.get("archiveUrl").asText()).body()).isEqualTo(ARCHIVE);
        assertThat(models.get(1).get("state").asText()).isEqualTo("new");
        assertThat(encoder.begun()).as("listing encodes nothing").isZero();
    }

    @Test
    void shouldServeAModelThatIsNamedBeyondLatin() throws Exception {
        Files.write(folder.resolve("椅子.jsm"), ARCHIVE);
        store.list(); // looks at once
        JsonNode chair = JSON.readTree(get("m/").body()).get("models").get(1);
        assertThat(chair.get("id").asText()).matches("椅子-jsm-[a-z2-9]{6}");
        String manifest = chair.get("manifestUrl").asText();
        assertThat(manifest).startsWith("%E6%A4%85%E5%AD%90-jsm-");
        JsonNode answer = JSON.readTree(get("m/" + manifest).body());
        assertThat(answer.get("id")).isEqualTo(chair.get("id"));
        assertThat(answer.get("name").asText()).isEqualTo("椅子");
        String archive =
                manifest.replace("manifest.json", answer.get("archiveUrl").asText());
        assertThat(get("m/" + archive).body()).isEqualTo(ARCHIVE);
        assertThat(get("m/"
                                + JSON.readTree(get("m/").body())
                                        .get("models")
                                        .get(1)
                                        .get("archiveUrl")
                                        .asText())
                        .body())
                .isEqualTo(ARCHIVE);
        // Its bare name leads to it, too.
        assertThat(JSON.readTree(get("m/%E6%A4%85%E5%AD%90/manifest.json").body()))
                .isEqualTo(answer);
    }

    @Test
    void shouldSendPeopleToThePage() throws Exception {
        HttpResponse<byte[]> answer = get("m/", "Accept", "text/html,application/xhtml+xml,*/*;q=0.8");
        assertThat(answer.statusCode()).isEqualTo(303);
        assertThat(location("m/", answer)).isEqualTo(server.root());
        assertThat(location("m", get("m"))).isEqualTo(server.root().resolve("m/"));
    }

    @Test
    void shouldCompressWhatItSaysOfModels() throws Exception {
        for (String path : List.of("m/bunny/manifest.json", "m/")) {
            HttpResponse<byte[]> plain = get(path);
            HttpResponse<byte[]> small = get(path, "Accept-Encoding", "br, gzip");
            if (plain.body().length < 1024) continue; // does not pay
            assertThat(header(small, "Content-Encoding")).isEqualTo("gzip");
            assertThat(header(small, "ETag")).isNotEqualTo(header(plain, "ETag"));
            assertThat(small.body().length).isLessThan(plain.body().length / 2);
            byte[] unpacked = new GZIPInputStream(new ByteArrayInputStream(small.body())).readAllBytes();
            assertThat(unpacked).isEqualTo(plain.body());
            assertThat(get(path, "If-None-Match", header(small, "ETag"), "Accept-Encoding", "gzip")
                            .statusCode())
                    .isEqualTo(304);
        }
        assertThat(get("m/bunny/manifest.json", "Accept-Encoding", "gzip").body().length)
                .isLessThan(get("m/bunny/manifest.json").body().length);
    }

    @Test
    void shouldDescribeAModel() throws Exception {
        HttpResponse<byte[]> answer = get("m/bunny/manifest.json");
        assertThat(answer.statusCode()).isEqualTo(200);
        assertThat(header(answer, "Cache-Control")).isEqualTo("public, max-age=10");
        JsonNode manifest = JSON.readTree(answer.body());
        assertThat(manifest.get("id").asText()).isEqualTo("bunny");
        assertThat(manifest.get("archiveSha256").asText()).isEqualTo(sha256);
        assertThat(manifest.get("archiveUrl").asText()).isEqualTo(sha256 + ".jsm");
        assertThat(manifest.get("batches")).hasSize(5);
        assertThat(manifest.get("batches").get(2).get("offset").asLong()).isEqualTo(1500);
        assertThat(manifest.get("batches").get(2).get("bytes").asLong()).isEqualTo(2000);
        HttpResponse<byte[]> again = get("m/bunny/manifest.json", "If-None-Match", header(answer, "ETag"));
        assertThat(again.statusCode()).isEqualTo(304);
        assertThat(again.body()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({"0-0, 0, 1000", "0-4, 0, 10500", "1-2, 1000, 3500", "4-4, 6500, 10500"})
    void shouldSendBatchesAsSlicesOfTheFile(String batches, int from, int to) throws Exception {
        HttpResponse<byte[]> answer = get("m/bunny/" + sha256 + "/batches/" + batches);
        assertThat(answer.statusCode()).isEqualTo(200);
        assertThat(answer.body()).isEqualTo(Arrays.copyOfRange(ARCHIVE, from, to));
        assertThat(header(answer, "Cache-Control")).contains("immutable");
        assertThat(header(answer, "Content-Length")).isEqualTo(Integer.toString(to - from));
        String tag = header(answer, "ETag");
        assertThat(get("m/bunny/" + sha256 + "/batches/" + batches, "If-None-Match", tag)
                        .statusCode())
                .isEqualTo(304);
    }

    @ParameterizedTest
    @ValueSource(strings = {"5-5", "0-5", "3-2", "00-1", "0-", "-1", "a-b", "0-99999999999999", "1"})
    void shouldNotFindBatchesThatDoNotExist(String batches) throws Exception {
        HttpResponse<byte[]> answer = get("m/bunny/" + sha256 + "/batches/" + batches);
        assertThat(answer.statusCode()).isEqualTo(404);
        assertError(answer);
    }

    @ParameterizedTest
    @CsvSource({
        // A thousand bytes hold batch 0; the index snaps down, and at least one batch is sent.
        "0, 1000, 1000, 0-0",
        "0, 1, 1, 0-0",
        "0, 1000, 1499, 0-0",
        "0, 1000, 1500, 0-1",
        "1, 1250, 2000, 1-2",
        "2, 100, 0, 2-2",
        "1, 1000000, 2000, 1-4",
        "4, 1, 1, 4-4"
    })
    void shouldSendAsManyPatchesAsFitIntoTheWait(int from, long bytesPerSecond, long waitMillis, String batches)
            throws Exception {
        String query = "patches?from=" + from + "&bytesPerSecond=" + bytesPerSecond + "&waitMillis=" + waitMillis;
        HttpResponse<byte[]> answer = get("m/bunny/" + sha256 + "/" + query);
        assertThat(answer.statusCode()).isEqualTo(200);
        assertThat(header(answer, "Cache-Control")).contains("no-store");
        URI canonical = answer.uri().resolve(header(answer, "Content-Location"));
        assertThat(canonical).isEqualTo(server.root().resolve("m/bunny/" + sha256 + "/batches/" + batches));
        assertThat(answer.body())
                .isEqualTo(get(canonical.getPath().substring(1)).body());
    }

    @Test
    void shouldSayThatNoPatchIsLeft() throws Exception {
        HttpResponse<byte[]> answer = get("m/bunny/" + sha256 + "/patches?from=5&bytesPerSecond=1000&waitMillis=2000");
        assertThat(answer.statusCode()).isEqualTo(204);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "?from=0",
                "?from=-1&bytesPerSecond=1&waitMillis=1",
                "?from=6&bytesPerSecond=1&waitMillis=1",
                "?from=x&bytesPerSecond=1&waitMillis=1",
                "?from=0&bytesPerSecond=NaN&waitMillis=1",
                "?from=0&bytesPerSecond=1e9&waitMillis=1",
                "?from=0&bytesPerSecond=1&waitMillis=9999999999999999999"
            })
    void shouldRefusePatchesWithoutGoodNumbers(String query) throws Exception {
        HttpResponse<byte[]> answer = get("m/bunny/" + sha256 + "/patches" + query);
        assertThat(answer.statusCode()).isEqualTo(400);
        assertError(answer);
    }

    @Test
    void shouldSayThatAnArchiveIsAnotherByNow() throws Exception {
        String stale = "0".repeat(64);
        for (String resource : List.of(".jsm", "/batches/0-0", "/patches?from=0&bytesPerSecond=1&waitMillis=1")) {
            HttpResponse<byte[]> answer = get("m/bunny/" + stale + resource);
            assertThat(answer.statusCode()).isEqualTo(404);
            assertThat(assertError(answer).get("error").asText()).contains(sha256);
            assertThat(answer.headers().firstValue("ETag")).isEmpty();
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "/m/nobody/manifest.json",
                "/m/bunny/other.json",
                "/m/Bunny/manifest.json",
                "/m/bunny.jsm",
                "/m/../../etc/passwd",
                "/m/%2e%2e/%2e%2e/etc/passwd",
                "/m/..%2f..%2fetc%2fpasswd/manifest.json",
                "/m/bunny%2fmanifest.json",
                "/m/%00/manifest.json",
                "/m/bunny%00/manifest.json",
                "/m/..%5c..%5cx/manifest.json",
                "/m/bunny;a=b/../x/manifest.json",
                "/m/%c0%ae%c0%ae/manifest.json",
                "/m/%/manifest.json"
            })
    void shouldNotFollowHostilePaths(String target) throws Exception {
        String answer = RawHttp.get(server.root(), target);
        assertThat(answer).matches("(?s)HTTP/1\\.1 (400|404) .*");
        assertThat(answer)
                .doesNotContain("root:")
                .doesNotContain(folder.toString())
                .doesNotContain("\tat ")
                .doesNotContain("Exception");
    }

    @Test
    void shouldSayWhyAModelCannotBeServed() throws Exception {
        Files.writeString(folder.resolve("empty.ply"), "bad");
        store.list(); // looks at once
        HttpResponse<byte[]> answer = get("m/empty/manifest.json");
        assertThat(answer.statusCode()).isEqualTo(422);
        assertThat(assertError(answer).get("error").asText()).contains("empty", "the mesh has no face");
        JsonNode row = JSON.readTree(get("m/").body()).get("models").get(1);
        assertThat(row.get("state").asText()).isEqualTo("failed");
        assertThat(row.get("error").asText()).contains("the mesh has no face");
        assertThat(get(archiveUrl()).statusCode()).isEqualTo(200);
    }

    @Test
    void shouldLetNobodyTakeDataForAPage() throws Exception {
        for (String path : List.of("m/", "m", archiveUrl(), "m/nobody/manifest.json")) {
            HttpResponse<byte[]> answer = get(path);
            assertThat(header(answer, "X-Content-Type-Options")).isEqualTo("nosniff");
            assertThat(header(answer, "Referrer-Policy")).isEqualTo("no-referrer");
            assertThat(header(answer, "Content-Security-Policy"))
                    .isEqualTo("default-src 'none'; frame-ancestors 'none'");
        }
    }
}
