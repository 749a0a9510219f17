package org.jsmesh.spark;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.objects.ObjectContent;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.ObjectStores;
import org.jsmesh.objects.Upload;
import org.jsmesh.s3.testing.S3Mock;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

@Tag("slow")
class CatalogueInBucketTest {
    /** What addresses of the web write otherwise. */
    private static final String ODD = "a b+c%20d ü/ö &=?#.ply";

    private final S3Mock s3 = S3Mock.shared();

    private static void put(ObjectStore store, String key, String content) throws IOException {
        store.put(Upload.of(key, ObjectContent.of(content.getBytes(StandardCharsets.UTF_8))));
    }

    private static byte[] read(ObjectStore store, String key) throws IOException {
        try (java.io.InputStream in = store.open(key)) {
            return in.readAllBytes();
        }
    }

    @Test
    void shouldPublishABucketInAnother() throws Exception {
        String in = "s3://" + s3.bucket() + "/raw models 100%25+ü";
        String out = "s3://" + s3.bucket() + "/site";
        try (ObjectStore models = ObjectStores.open(in);
                ObjectStore site = ObjectStores.open(out)) {
            for (int i = 0; i < 6; i++) put(models, "d" + i % 2 + "/m" + i + ".ply", Patches.ply(4 + i, i));
            put(
                    models,
                    "red.obj",
                    "mtllib Red.MTL\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                            + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
            put(models, "red.mtl", "newmtl red\nKd 1 0 0\n");
            put(models, "bad.ply", "ply\nnonsense\n");
            put(models, ODD, Patches.ply(5, 5));
            put(models, "notes.txt", "no model");
            CatalogueSettings settings = Cluster.settings(in, out);
            Outcome first = Cluster.run(settings);
            assertThat(List.of(first.encoded(), first.failed(), first.published()))
                    .containsExactly(8L, 1L, 8L);
            assertThat(first.failures().get(0).failure().place())
                    .startsWith("s3://")
                    .contains("/bad.ply, line");
            JsonNode page = new ObjectMapper().readTree(read(site, "m/index.json"));
            assertThat(page.findValuesAsText("id"))
                    .containsExactly(
                            "a-b-c-20d-u--o", "d0--m0", "d0--m2", "d0--m4", "d1--m1", "d1--m3", "d1--m5", "red");
            for (JsonNode row : page.path("models")) {
                String archive = "m/" + row.path("archiveUrl").asText();
                assertThat(site.find(archive).orElseThrow().bytes())
                        .isEqualTo(row.path("bytes").asLong());
            }

            Outcome second = Cluster.run(settings);
            assertThat(List.of(second.skipped(), second.encoded(), second.failed()))
                    .containsExactly(8L, 0L, 1L);

            put(models, "red.mtl", "newmtl red\nKd 0 0 1\n");
            put(models, "d0/m0.ply", Patches.ply(7, 9));
            models.delete("bad.ply");
            Outcome third = Cluster.run(new CatalogueSettings(
                    settings.inputs(),
                    List.of(),
                    out,
                    settings.report(),
                    "https://example.org/",
                    true,
                    EncoderSettings.defaults()));
            assertThat(List.of(third.skipped(), third.encoded(), third.failed(), third.published()))
                    .containsExactly(6L, 2L, 0L, 8L);
            // The pages of these tell of the site's address now.
            assertThat(new String(read(site, "m/red/index.html"), StandardCharsets.UTF_8))
                    .contains("https://example.org/m/red/");
            Map<String, Long> left = new HashMap<>();
            try (ObjectStore report = ObjectStores.open(settings.report())) {
                report.list("", "", object -> left.put(object.key(), object.bytes()) == null);
            }
            assertThat(left.keySet()).hasSize(3).anyMatch(key -> key.endsWith(".parquet"));
        }
    }

    @Test
    void shouldReadAListThatLiesInABucket() throws Exception {
        String bucket = "s3://" + s3.bucket();
        try (ObjectStore store = ObjectStores.open(bucket)) {
            List<String> lines = new ArrayList<>();
            for (int i = 0; i < 3; i++) {
                put(store, "in/" + i + "/" + ODD, Patches.ply(4, i));
                lines.add(bucket + "/in/" + i + "/" + ODD + "\tset/" + i + ".ply");
            }
            put(store, "list.txt", String.join("\n", lines));
            CatalogueSettings settings = new CatalogueSettings(
                    List.of(),
                    List.of(bucket + "/list.txt"),
                    bucket + "/site",
                    bucket + "/report",
                    null,
                    false,
                    EncoderSettings.defaults());
            assertThat(Cluster.run(settings).encoded()).isEqualTo(3);
            assertThat(store.find("site/m/set--2/manifest.json")).isPresent();
        }
    }
}
