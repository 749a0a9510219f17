package org.jsmesh.desktop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class ScreenshotRunTest {
    private final BufferedImage picture = new BufferedImage(3, 2, BufferedImage.TYPE_INT_ARGB);

    @TempDir
    private Path folder;

    @Test
    void shouldWriteAPicture() throws IOException {
        File png = folder.resolve("x.png").toFile();
        ScreenshotRun.write(picture, png);
        assertThat(ImageIO.read(png).getWidth()).isEqualTo(3);
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void shouldSayThatAPictureCannotBeWritten() {
        assertThatThrownBy(() -> ScreenshotRun.write(picture, new File("/proc/x.png")))
                .isInstanceOf(ViewerException.class)
                .hasMessageContaining("/proc/x.png: cannot be written")
                .hasMessageContaining("choose another place");
    }

    @Test
    void shouldNotReplaceTheModel() throws IOException {
        Path model = Files.writeString(folder.resolve("model.png"), "an archive with a strange name");
        ScreenshotRun run = new ScreenshotRun(model.toString(), new PictureSize(10, 10), true, null);
        assertThatThrownBy(() -> run.run(model.toFile(), 1000))
                .isInstanceOf(ViewerException.class)
                .hasMessageContaining("is the model itself");
        assertThat(model).hasContent("an archive with a strange name");
    }
}
