package org.jsmesh.poster;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.util.Random;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class JpegTest {
    @ParameterizedTest
    @CsvSource({"480, 360", "16, 16", "37, 21", "1, 1", "33, 48"})
    void shouldShowWhatItIsGiven(int width, int height) throws Exception {
        int[] rgb = smooth(width, height);
        BufferedImage read = read(new Jpeg(width, height, rgb).file(95));
        assertThat(read.getWidth()).isEqualTo(width);
        assertThat(read.getHeight()).isEqualTo(height);
        double sum = 0;
        for (int i = 0; i < rgb.length; i++)
            sum += PosterTest.difference(rgb[i], read.getRGB(i % width, i / width) & 0xffffff);
        assertThat(sum / rgb.length).isLessThan(6);
    }

    @Test
    void shouldKeepPlainColours() throws Exception {
        int[] colours = {0x000000, 0xffffff, 0xff0000, 0x00ff00, 0x0000ff, 0x808080};
        for (int colour : colours) {
            int[] rgb = new int[32 * 32];
            java.util.Arrays.fill(rgb, colour);
            BufferedImage read = read(new Jpeg(32, 32, rgb).file(90));
            assertThat(PosterTest.difference(colour, read.getRGB(13, 21) & 0xffffff))
                    .as(Integer.toHexString(colour))
                    .isLessThanOrEqualTo(3);
        }
    }

    @Test
    void shouldFitNoiseAtEveryQuality() throws Exception {
        int[] rgb = new Random(1).ints(480 * 360, 0, 1 << 24).toArray();
        Jpeg jpeg = new Jpeg(480, 360, rgb);
        for (int quality : new int[] {1, 10, 50, 100})
            assertThat(read(jpeg.file(quality))).isNotNull();
        assertThat(jpeg.within(100_000, 90)).hasSizeLessThanOrEqualTo(100_000);
        assertThat(jpeg.within(60_000, 90).length).isLessThan(jpeg.within(100_000, 90).length);
    }

    @Test
    void shouldTakeTheFinestThatFits() {
        Jpeg jpeg = new Jpeg(96, 64, smooth(96, 64));
        byte[] all = jpeg.within(1 << 20, 85);
        assertThat(all).isEqualTo(jpeg.file(85));
        byte[] less = jpeg.within(all.length - 1, 85);
        assertThat(less.length).isLessThan(all.length);
    }

    @Test
    void shouldShortenCodesThatGrowTooLong() {
        HuffmanTable table = new HuffmanTable();
        long[] counts = {1, 1};
        for (int symbol = 0; symbol < 24; symbol++) {
            for (long i = 0; i < counts[0]; i++) table.count(symbol);
            counts = new long[] {counts[1], counts[0] + counts[1]};
        }
        table.build();
        double room = 0;
        for (int symbol = 0; symbol < 24; symbol++) {
            assertThat(table.length(symbol)).isBetween(1, 16);
            assertThat(table.code(symbol)).as("not ones alone").isLessThan((1 << table.length(symbol)) - 1);
            room += 1.0 / (1 << table.length(symbol));
        }
        assertThat(room).isLessThan(1);
        assertThat(table.length(23)).isLessThan(table.length(5));
    }

    private static int[] smooth(int width, int height) {
        int[] rgb = new int[width * height];
        for (int i = 0; i < rgb.length; i++) {
            int x = i % width * 255 / width;
            int y = i / width * 255 / height;
            rgb[i] = x << 16 | y << 8 | (255 - x / 2 - y / 2);
        }
        return rgb;
    }

    private static BufferedImage read(byte[] jpeg) throws Exception {
        return ImageIO.read(new ByteArrayInputStream(jpeg));
    }
}
