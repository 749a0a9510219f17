package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.jsmesh.s3.testing.S3Mock;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import software.amazon.awssdk.core.sync.RequestBody;
import software.amazon.awssdk.services.s3.model.HeadObjectResponse;
import software.amazon.awssdk.services.s3.model.S3Object;

/** {@code jsm encode --site s3://bucket/prefix}. */
class BucketSiteTest {
    private static final S3Mock MOCK = S3Mock.shared();
    private static final String FOR_EVER = "public, max-age=31536000, immutable, no-transform";

    private final String bucket = MOCK.bucket();
    private final String site = "s3://" + bucket + "/some/site";

    @TempDir
    private Path folder;

    @BeforeEach
    void makeModels() throws IOException {
        Bumpy.write(folder.resolve("a.ply"), 8);
        Bumpy.write(folder.resolve("b.ply"), 9);
        Files.writeString(folder.resolve("a.annotations.json"), "{\"annotations\": []}");
    }

    /** Tags by keys below the site. */
    private Map<String, String> objects() {
        return MOCK.client().listObjectsV2(b -> b.bucket(bucket)).contents().stream()
                .collect(Collectors.toMap(
                        object -> object.key().substring("some/site/".length()),
                        object -> object.eTag() + object.lastModified(),
                        (x, y) -> x,
                        TreeMap::new));
    }

    private HeadObjectResponse head(String key) {
        return MOCK.client().headObject(b -> b.bucket(bucket).key("some/site/" + key));
    }

    private JsonNode json(String key) throws IOException {
        return new ObjectMapper()
                .readTree(MOCK.client()
                        .getObjectAsBytes(b -> b.bucket(bucket).key("some/site/" + key))
                        .asByteArray());
    }

    @Test
    void shouldWriteASiteToABucket() throws Exception {
        Cli.ok("encode", folder, "--site", site);
        JsonNode rows = json("m/index.json").get("models");
        assertThat(rows.findValuesAsText("id")).containsExactly("a", "b");
        String archive = "m/" + rows.get(0).get("archiveUrl").asText();
        assertThat(head(archive).contentType()).isEqualTo("model/vnd.jsm");
        assertThat(head(archive).cacheControl()).isEqualTo(FOR_EVER);
        assertThat(head("m/" + rows.get(0).get("posterUrl").asText()).contentType())
                .isEqualTo("image/jpeg");
        for (String key : new String[] {"index.html", "m/index.json", "m/a/manifest.json", "m/a/index.html"})
            assertThat(head(key).cacheControl()).as(key).isEqualTo("no-cache");
        assertThat(head("m/a/index.html").contentType()).startsWith("text/html");
        assertThat(objects().keySet())
                .anySatisfy(key -> assertThat(key).matches("viewer/viewer-\\w+\\.js"))
                .noneMatch(key -> key.contains("lock") || key.contains(".encoding"));

        // The same files as in a folder.
        Path local = folder.resolveSibling(folder.getFileName() + "-site");
        Cli.ok("encode", folder.resolve("a.ply"), folder.resolve("b.ply"), "--site", "-o", local);
        byte[] manifest = Files.readAllBytes(local.resolve("m/a/manifest.json"));
        assertThat(json("m/a/manifest.json")).isEqualTo(new ObjectMapper().readTree(manifest));

        Map<String, String> before = objects();
        Cli.ok("encode", folder.resolve("b.ply"), "--site", site);
        assertThat(objects()).as("what does not change is left alone").isEqualTo(before);

        Cli.ok("encode", folder.resolve("b.ply"), "--site", site, "--prune");
        assertThat(json("m/index.json").get("models").findValuesAsText("id")).containsExactly("b");
        assertThat(objects().keySet()).noneMatch(key -> key.startsWith("m/a/"));
    }

    @Test
    void shouldSayWhyItWritesNothing() {
        assertThat(Cli.run("encode", folder, "-o", site).err()).contains("To write to a bucket, make a site: --site");
        Cli wrong = Cli.run("encode", folder, "--site", "s3://no-such-bucket/x");
        assertThat(wrong.err()).contains("s3://no-such-bucket/x", "there is no such bucket");
        assertThat(Cli.run("encode", folder, "--site", "gs://x/y").err()).contains("nothing here opens addresses");
        MOCK.client().putObject(b -> b.bucket(bucket).key("some/site/index.html"), RequestBody.fromString("<p>mine"));
        assertThat(Cli.run("encode", folder, "--site", site).err())
                .contains("is a page of another site, nothing is written. Choose another bucket or prefix");
        assertThat(MOCK.client().listObjectsV2(b -> b.bucket(bucket)).contents())
                .extracting(S3Object::key)
                .containsExactly("some/site/index.html");
    }
}
