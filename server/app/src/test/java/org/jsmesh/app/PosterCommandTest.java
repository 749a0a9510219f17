package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code jsm poster}, and what other commands say of posters. */
class PosterCommandTest {
    @TempDir
    private Path folder;

    private Path archive;

    @BeforeEach
    void encode() throws Exception {
        Bumpy.write(folder.resolve("ring.ply"), 30);
        archive = folder.resolve("ring.jsm");
        Cli.ok("encode", folder.resolve("ring.ply"), "-o", archive);
    }

    @Test
    void shouldWriteThePoster() throws Exception {
        Path picture = folder.resolve("ring.jpg");
        Cli cli = Cli.ok("poster", archive, "-o", picture);
        assertThat(cli.out()).contains(picture + ": " + Files.size(picture) + " bytes");
        assertThat(ImageIO.read(picture.toFile()).getWidth()).isEqualTo(480);
        assertThat(Cli.ok("info", archive).out()).contains("poster of " + Files.size(picture) + " bytes from byte ");
    }

    @Test
    void shouldLeaveThePosterOut() throws Exception {
        long shown = Files.size(archive);
        Cli.ok("encode", folder.resolve("ring.ply"), "-o", archive, "--no-poster");
        assertThat(Files.size(archive)).isLessThan(shown - 2000);
        assertThat(Cli.ok("info", archive).out()).doesNotContain("poster of");
        Cli cli = Cli.run("poster", archive, "-o", folder.resolve("ring.jpg"));
        assertThat(cli.code()).isEqualTo(1);
        assertThat(cli.err()).contains("ring.jsm: the archive has no poster", "--no-poster");
        assertThat(folder.resolve("ring.jpg")).doesNotExist();
    }

    @Test
    void shouldKeepTheArchive() throws Exception {
        Cli cli = Cli.run("poster", archive, "-o", archive);
        assertThat(cli.code()).isEqualTo(2);
        assertThat(cli.err()).contains("the input itself");
        assertThat(Cli.ok("info", archive).out()).contains("poster of");
    }

    @Test
    void shouldTellWhoShowsLinksWhereASiteIs() throws Exception {
        Path site = folder.resolve("site");
        Cli.ok("encode", folder.resolve("ring.ply"), "--site", site, "--public-url", "https://x.example/rings");
        String page = Files.readString(site.resolve("m/ring/index.html"));
        assertThat(page)
                .contains("<title>ring · jSM</title>", "data:image/jpeg;base64,")
                .containsPattern("og:image\" content=\"https://x.example/rings/m/ring/[0-9a-f]{64}/poster.jpg\"");
        Cli cli = Cli.run("encode", folder.resolve("ring.ply"), "--site", site, "--public-url", "javascript:x");
        assertThat(cli.code()).isEqualTo(2);
        assertThat(cli.err()).contains("--public-url javascript:x is no address");
    }
}
