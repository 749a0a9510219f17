package org.jsmesh.files;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.BatchIndexBuilder;
import org.jsmesh.archive.BatchKind;
import org.jsmesh.archive.ChannelInfo;
import org.jsmesh.archive.ImageInfo;
import org.jsmesh.archive.Provenance;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.UpAxis;
import org.junit.jupiter.api.Test;

class ArchiveReportTest {
    private static final ArchiveHeader HEADER = new ArchiveHeader(
            40,
            22,
            30,
            List.of(new ChannelInfo(Channel.Semantic.NORMAL, "normal", 3, Channel.Type.FLOAT32)),
            List.of(Material.named("wood")),
            List.of(new ImageInfo(List.of("wood.png"), 5, "cd".repeat(32))),
            List.of(),
            new double[3],
            new float[] {-1, -2, -3, 1, 2, 3},
            UpAxis.Z,
            false,
            List.of(new ArchiveHeader.Level(.25, 40, 0)),
            "ab".repeat(32),
            new Provenance("OBJ", List.of(Note.dropped("3 group names not kept.", 3, "wheel"))),
            new BatchIndexBuilder()
                    .add(BatchKind.BASE, 100, 0)
                    .after(12, 8, 1.5)
                    .add(BatchKind.SPLITS, 60, 14)
                    .after(40, 22, 0)
                    .in(1, 1)
                    .add(BatchKind.TEXTURE, 9, 0)
                    .after(40, 22, 0)
                    .build());

    @Test
    void shouldNameEveryFieldThatProgramsRelyOn() throws Exception {
        JsonNode json = new ObjectMapper()
                .readTree(ArchiveReport.of(HEADER, "cd".repeat(32)).toJson());
        assertThat(names(json))
                .containsExactly(
                        "faces",
                        "vertices",
                        "wedges",
                        "channels",
                        "materials",
                        "textures",
                        "faceChannels",
                        "bounds",
                        "origin",
                        "up",
                        "bytes",
                        "meshSha256",
                        "modelSha256",
                        "archiveSha256",
                        "baseFaces",
                        "baseBytes",
                        "levels",
                        "sourceFormat",
                        "notes",
                        "batches");
        assertThat(json.get("channels").toString())
                .isEqualTo("[{\"name\":\"normal\",\"semantic\":\"normal\",\"components\":3,\"type\":\"float32\"}]");
        assertThat(json.get("levels").toString()).isEqualTo("[{\"threshold\":0.25,\"faces\":40,\"errorMean\":0.0}]");
        assertThat(json.get("batches").get(1).toString())
                .isEqualTo(
                        "{\"offset\":100,\"bytes\":60,\"kind\":\"splits\",\"patches\":14,\"faces\":40,\"vertices\":22,"
                                + "\"precisionBits\":32,\"errorMean\":0.0,\"errorQuantile\":0.0,\"errorBound\":0.0,\"level\":1,\"pass\":1}");
        assertThat(json.get("modelSha256").asText()).isEqualTo(HEADER.modelSha256());
        assertThat(json.get("sourceFormat").asText()).isEqualTo("OBJ");
        assertThat(json.get("notes").toString())
                .isEqualTo(
                        "[{\"kind\":\"dropped\",\"text\":\"3 group names not kept.\",\"count\":3,\"example\":\"wheel\","
                                + "\"warning\":false}]");
        assertThat(json.get("bytes").asLong()).isEqualTo(169);
        assertThat(json.get("baseFaces").asInt()).isEqualTo(12);
        assertThat(json.get("baseBytes").asInt()).isEqualTo(100);
    }

    @Test
    void shouldPutNameAndAddressBeforeTheSameFieldsInAManifest() throws Exception {
        ArchiveReport report = ArchiveReport.of(HEADER, "cd".repeat(32));
        JsonNode manifest = new ObjectMapper().readTree(report.toManifestJson("teapot", "Tea pot", "x.jsm", null));
        List<String> names = names(manifest);
        assertThat(names.subList(0, 5)).containsExactly("id", "name", "archiveUrl", "firstUrl", "firstBytes");
        assertThat(manifest.get("firstUrl").asText()).isEqualTo("x/first.jsm");
        assertThat(manifest.get("firstBytes").asInt()).isEqualTo(169);
        assertThat(names.subList(5, names.size())).isEqualTo(names(new ObjectMapper().readTree(report.toJson())));
        assertThat(manifest.get("archiveUrl").asText()).isEqualTo("x.jsm");
    }

    private static List<String> names(JsonNode json) {
        List<String> names = new ArrayList<>();
        json.fieldNames().forEachRemaining(names::add);
        return names;
    }
}
