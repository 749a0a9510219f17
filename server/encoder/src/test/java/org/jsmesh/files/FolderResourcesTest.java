package org.jsmesh.files;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jsmesh.mesh.io.Resource;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Paths of models that nobody should believe. */
class FolderResourcesTest {
    @TempDir
    private Path temp;

    private Path folder;

    @BeforeEach
    void make() throws IOException {
        folder = Files.createDirectories(temp.resolve("model"));
        Files.createDirectories(folder.resolve("tex"));
        Files.writeString(folder.resolve("tex/wood.png"), "WOOD");
        Files.writeString(folder.resolve("stone.png"), "STONE");
        Files.writeString(temp.resolve("secret.png"), "SECRET");
        Files.writeString(Files.createDirectories(temp.resolve("model-2")).resolve("secret.png"), "SECRET");
    }

    private String find(String path) throws IOException {
        return new FolderResources(folder).find(path).map(String::new).orElse(null);
    }

    @ParameterizedTest
    @ValueSource(strings = {"tex/wood.png", "tex\\wood.png", "./tex/wood.png", "tex/../tex/wood.png", "tex//wood.png"})
    void shouldFindWhatIsBelow(String path) throws IOException {
        assertThat(find(path)).isEqualTo("WOOD");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "C:\\Users\\me\\stone.png",
                "C:/stone.png",
                "/home/me/stone.png",
                "../stone.png",
                "\\\\host\\share\\stone.png"
            })
    void shouldFindByTheLastPartWhatPathsOfAnotherMachineMean(String path) throws IOException {
        assertThat(find(path)).isEqualTo("STONE");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"TEX/wood.png", "tex/Wood.PNG", "Tex\\WOOD.png", ".\\tEx\\.\\wood.png", "old/../Tex/Wood.png"})
    void shouldFindWhateverTheCaseOfLettersAndTellWhere(String path) throws IOException {
        Resource found = new FolderResources(folder).locate(path).orElseThrow();
        assertThat(found.path()).isEqualTo("tex/wood.png");
        assertThat(found.content()).asString().isEqualTo("WOOD");
    }

    @ParameterizedTest
    @ValueSource(strings = {"D:\\Work\\Stone.PNG", "/home/me/STONE.png", "maps/stone.PNG"})
    void shouldFindTheLastPartWhateverItsCase(String path) throws IOException {
        assertThat(new FolderResources(folder).locate(path).orElseThrow().path())
                .isEqualTo("stone.png");
    }

    @Test
    void shouldTakeTheExactNameFirst() throws IOException {
        Files.writeString(folder.resolve("STONE.png"), "LOUD");
        Files.writeString(folder.resolve("Stone.png"), "MIXED");
        assertThat(find("stone.png")).isEqualTo("STONE");
        assertThat(find("x/Stone.png")).isEqualTo("MIXED");
        assertThat(find("stone.PNG")).isEqualTo("LOUD");
    }

    @Test
    void shouldFindANameWhoseAccentsArePutTogetherInAnotherWay() throws IOException {
        Files.writeString(folder.resolve("fac\u0327ade.png"), "FRONT");
        assertThat(find("Fa\u00e7ade.png")).isEqualTo("FRONT");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "../secret.png",
                "../SECRET.png",
                "..\\Secret.PNG",
                "TEX/../../Secret.png",
                "../Model-2/secret.png",
                "UP/Secret.png",
                "Up/Model-2/SECRET.png",
                "..\\secret.png",
                "tex/../../secret.png",
                "../model-2/secret.png",
                "C:secret.png",
                "C:\\secret.png",
                "\\\\?\\C:\\secret.png",
                "file:///secret.png",
                "secret.png\0.jpg",
                "..",
                ".",
                "/",
                "",
                "tex"
            })
    void shouldFindNothingElsewhere(String path) throws IOException {
        Files.createSymbolicLink(folder.resolve("up"), temp);
        assertThat(find(path)).isNull();
    }

    @Test
    void shouldFindNothingByAnAbsolutePath() throws IOException {
        assertThat(find(temp.resolve("secret.png").toString())).isNull();
        assertThat(find(temp.resolve("secret.png").toUri().toString())).isNull();
    }

    @Test
    void shouldFollowLinksWithinAndNoneThatLeadOut() throws IOException {
        Files.createSymbolicLink(folder.resolve("in.png"), Path.of("tex", "wood.png"));
        Files.createSymbolicLink(folder.resolve("out.png"), temp.resolve("secret.png"));
        Files.createSymbolicLink(folder.resolve("up"), temp);
        Files.createSymbolicLink(folder.resolve("nowhere.png"), folder.resolve("gone.png"));
        assertThat(find("in.png")).isEqualTo("WOOD");
        assertThat(find("out.png")).isNull();
        assertThat(find("up/secret.png")).isNull();
        assertThat(find("up/model/tex/wood.png")).isEqualTo("WOOD");
        assertThat(find("nowhere.png")).isNull();
    }

    @Test
    void shouldWorkThroughALinkToTheFolderAndByARelativePath() throws IOException {
        Path link = Files.createSymbolicLink(temp.resolve("link"), folder);
        assertThat(new FolderResources(link).find("tex/wood.png")).isPresent();
        Path relative = Path.of("").toAbsolutePath().relativize(folder);
        assertThat(new FolderResources(relative).find("tex/wood.png")).isPresent();
        assertThat(new FolderResources(relative).find("../secret.png")).isEmpty();
        assertThat(new FolderResources(temp.resolve("gone")).find("stone.png")).isEmpty();
    }
}
