package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.jsmesh.files.ArchiveFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What the commands call the original, and what they say of the rest. */
class ClaimsTest {
    private static final String IDENTICAL = "identical to the original file's geometry, materials and pictures";

    @TempDir
    private Path folder;

    /** What decode, fetch and verify print and answer for an archive and its model. */
    private List<Cli> claims(Path archive, Path model) {
        Path out = folder.resolve("again.obj");
        return List.of(
                Cli.run("decode", archive, "-o", out),
                Cli.run("fetch", archive.toUri(), "-o", out, "--full"),
                Cli.run("verify", archive, model));
    }

    @Test
    void shouldCallIdenticalWhatHasAllOfItsFile() throws IOException {
        Path model = ClaimedModels.painted(folder.resolve("m"));
        Path archive = ClaimedModels.archive(model, folder.resolve("painted.jsm"));
        for (Cli cli : claims(archive, model)) {
            assertThat(cli.code()).as(cli.err()).isZero();
            assertThat(cli.out()).contains(IDENTICAL).doesNotContain("not kept", "warning");
            assertThat(cli.err()).doesNotContain("not kept", "warning");
        }
        String modelSha256 = ArchiveFile.read(archive).header().modelSha256();
        assertThat(Cli.ok("verify", archive, model).out()).contains("model SHA-256 " + modelSha256);
        assertThat(Cli.ok("info", archive).out())
                .contains("model SHA-256   " + modelSha256 + " (mesh and pictures)", "from a file of format OBJ")
                .doesNotContain("not kept", "warning");
    }

    @Test
    void shouldCallNothingTheOriginalWhosePictureWasAltered() throws IOException {
        Path model = ClaimedModels.painted(folder.resolve("m"));
        Path archive = ClaimedModels.archive(model, folder.resolve("painted.jsm"));
        Path altered = ClaimedModels.altered(archive, folder.resolve("altered.jsm"));
        for (Cli cli : claims(altered, model)) {
            assertThat(cli.code()).isEqualTo(1);
            assertThat(cli.err()).contains("the picture wood.png is not the one that was encoded");
            assertThat(cli.out()).doesNotContain("identical", "the original");
        }
    }

    @Test
    void shouldNameThePictureThatIsAnotherBesideTheFile() throws IOException {
        Path model = ClaimedModels.painted(folder.resolve("m"));
        Path archive = ClaimedModels.archive(model, folder.resolve("painted.jsm"));
        Files.writeString(model.resolveSibling("wood.png"), "another picture");
        Cli cli = Cli.run("verify", archive, model);
        assertThat(cli.code()).isEqualTo(1);
        assertThat(cli.err()).containsOnlyOnce("\n").contains("the picture wood.png differs at byte 0");
        assertThat(cli.out()).isEmpty();
    }

    @Test
    void shouldNameThePictureThatTheArchiveDoesNotHave() throws IOException {
        Path model = ClaimedModels.unpainted(folder.resolve("m"));
        Path archive = ClaimedModels.archive(model, folder.resolve("painted.jsm"));
        Files.writeString(model.resolveSibling("wood.png"), "found again");
        Cli cli = Cli.run("verify", archive, model);
        assertThat(cli.code()).isEqualTo(1);
        assertThat(cli.err()).contains("the archive has no picture wood.png");
    }

    @Test
    void shouldWarnWhereSomethingThatIsSeenIsMissing() throws IOException {
        Path model = ClaimedModels.unpainted(folder.resolve("m"));
        Path archive = ClaimedModels.archive(model, folder.resolve("painted.jsm"));
        String warning = "warning: not the whole original: textures not found: wood.png";
        for (Cli cli : claims(archive, model)) {
            assertThat(cli.code()).as(cli.err()).isZero();
            assertThat(cli.out()).contains(warning).doesNotContain("identical");
        }
        assertThat(Cli.ok("info", archive).out())
                .contains("warning: not the whole original: Textures not found: wood.png.");
    }

    @Test
    void shouldSayBesideIdenticalWhatOfTheFileIsNotKept() throws IOException {
        Path model = ClaimedModels.annotated(folder.resolve("annotated.ply"));
        Path archive = ClaimedModels.archive(model, folder.resolve("annotated.jsm"));
        for (Cli cli : claims(archive, model)) {
            assertThat(cli.code()).as(cli.err()).isZero();
            assertThat(cli.out()).contains(IDENTICAL);
            assertThat(cli.out() + cli.err()).contains("of the file not kept: ", "hinge");
        }
        assertThat(Cli.ok("info", archive).out()).contains("of the file not kept: ", "hinge");
        JsonNode json =
                new ObjectMapper().readTree(Cli.ok("info", archive, "--json").out());
        assertThat(json.get("sourceFormat").asText()).isEqualTo("PLY");
        assertThat(json.get("notes")).hasSize(1);
        assertThat(json.get("notes").get(0).get("text").asText()).contains("hinge");
        assertThat(json.get("notes").get(0).get("warning").asBoolean()).isFalse();
    }

    /** A file that has more than the one that was encoded, none of which a mesh holds. */
    @Test
    void shouldNameWhatTheFileHasThatTheArchiveHasNot() throws IOException {
        Path model = ClaimedModels.annotated(folder.resolve("annotated.ply"));
        Path plain = Files.writeString(
                folder.resolve("plain.ply"),
                Files.readString(model)
                        .replace("element hinge 1\nproperty int a\n", "")
                        .replace("\n7\n", "\n"));
        Path archive = ClaimedModels.archive(plain, folder.resolve("plain.jsm"));
        assertThat(Cli.ok("verify", archive, plain).out()).doesNotContain("not kept");
        assertThat(Cli.ok("verify", archive, model).out()).contains("of the file not kept: ", "hinge");
    }
}
