package org.jsmesh.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;

class PictureTest {
    @Test
    void shouldBecomeAFileThatJavaReads() throws Exception {
        int[] rgb = new int[7 * 3]; // rows that end amid four bytes
        for (int i = 0; i < rgb.length; i++) rgb[i] = 0x123456 * (i + 1) & 0xffffff;
        BufferedImage image = ImageIO.read(new ByteArrayInputStream(new Picture("a.png", 7, 3, rgb).bmp()));
        assertThat(image.getWidth()).isEqualTo(7);
        assertThat(image.getHeight()).isEqualTo(3);
        for (int i = 0; i < rgb.length; i++)
            assertThat(image.getRGB(i % 7, i / 7) & 0xffffff).as("pixel %d", i).isEqualTo(rgb[i]);
    }

    @Test
    void shouldRefuseAnotherNumberOfColours() {
        assertThatThrownBy(() -> new Picture("a.png", 2, 2, new int[3])).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new Picture("a.png", 1 << 16, 1 << 16, new int[0]))
                .isInstanceOf(IllegalArgumentException.class);
    }
}
