package org.jsmesh.display;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.Random;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RasterTest {
    private static final int FROM_TOP = 0x20;
    private static final int RED = 0xffff0000;
    private static final int GREEN = 0xff00ff00;
    private static final int BLUE = 0xff0000ff;
    private static final int WHITE = 0xffffffff;

    private static byte[] bytes(int... values) {
        byte[] bytes = new byte[values.length];
        for (int i = 0; i < bytes.length; i++) bytes[i] = (byte) values[i];
        return bytes;
    }

    /** A file of 2 x 2 pixels. */
    private static byte[] tga(int kind, int bits, int descriptor, int... data) {
        byte[] file = Arrays.copyOf(
                bytes(0, 0, kind, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 2, 0, bits, descriptor), 18 + data.length);
        System.arraycopy(bytes(data), 0, file, 18, data.length);
        return file;
    }

    private static int[] pixels(byte[] file) {
        return Raster.ofTga(file).argb();
    }

    @Test
    void shouldReadColoursFromBelowAndFromAbove() {
        int[] data = {0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255};
        assertThat(pixels(tga(2, 24, FROM_TOP, data))).containsExactly(RED, GREEN, BLUE, WHITE);
        assertThat(pixels(tga(2, 24, 0, data))).containsExactly(BLUE, WHITE, RED, GREEN);
        assertThat(pixels(tga(2, 24, FROM_TOP | 0x10, data))).containsExactly(GREEN, RED, WHITE, BLUE);
    }

    @Test
    void shouldReadRunsAndRawPackets() {
        assertThat(pixels(tga(10, 24, FROM_TOP, 0x82, 0, 0, 255, 0x00, 255, 0, 0)))
                .containsExactly(RED, RED, RED, BLUE);
        assertThat(pixels(tga(11, 8, FROM_TOP, 0x01, 0, 128, 0x81, 255)))
                .containsExactly(0xff000000, 0xff808080, WHITE, WHITE);
    }

    @Test
    void shouldReadColoursOf15And16Bits() {
        assertThat(pixels(tga(2, 16, FROM_TOP, 0, 0x7c, 0xe0, 0x03, 0x1f, 0, 0xff, 0x7f)))
                .containsExactly(RED, GREEN, BLUE, WHITE);
        assertThat(pixels(tga(2, 16, FROM_TOP | 1, 0, 0xfc, 0xe0, 0x03, 0x1f, 0x80, 0xff, 0x7f)))
                .containsExactly(RED, 0x0000ff00, BLUE, 0x00ffffff);
    }

    @Test
    void shouldReadAColourMap() {
        byte[] file = bytes(
                3, 1, 1, 0, 0, 2, 0, 24, 0, 0, 0, 0, 2, 0, 1, 0, 8, FROM_TOP, 'x', 'y', 'z', 255, 0, 0, 0, 0, 255, 1,
                0);
        assertThat(pixels(file)).containsExactly(RED, BLUE);
    }

    @Test
    void shouldReadOpacityUnlessItIsUnused() {
        int[] data = {0, 0, 255, 128, 0, 255, 0, 0, 255, 0, 0, 255, 255, 255, 255, 255};
        assertThat(pixels(tga(2, 32, FROM_TOP | 8, data))).containsExactly(0x80ff0000, 0x0000ff00, BLUE, WHITE);
        assertThat(pixels(tga(2, 32, FROM_TOP, data))).containsExactly(RED, GREEN, BLUE, WHITE);
        int[] unused = data.clone();
        for (int i = 3; i < 16; i += 4) unused[i] = 0;
        assertThat(pixels(tga(2, 32, FROM_TOP | 8, unused))).containsExactly(RED, GREEN, BLUE, WHITE);
    }

    @Test
    void shouldReadNothingFromOtherAndDamagedFiles() {
        byte[] whole = tga(2, 24, 0, new int[12]);
        assertThat(Raster.ofTga(whole)).isNotNull();
        for (int length = 0; length < whole.length; length++)
            assertThat(Raster.ofTga(Arrays.copyOf(whole, length))).isNull();
        assertThat(Raster.ofTga(tga(10, 24, 0, 0x82, 0, 0, 255))).isNull();
        assertThat(Raster.ofTga(
                        bytes(0x89, 'P', 'N', 'G', 13, 10, 26, 10, 0, 0, 0, 13, 'I', 'H', 'D', 'R', 0, 0, 0, 1)))
                .isNull();
        assertThat(Raster.ofTga(Arrays.copyOf(bytes('B', 'M', 54, 0, 0, 0, 0, 0, 0, 0, 54, 0, 0, 0, 40), 100)))
                .isNull();
        assertThat(Raster.ofTga(Arrays.copyOf(bytes(0xff, 0xd8, 0xff, 0xe0, 0, 16, 'J', 'F', 'I', 'F'), 100)))
                .isNull();
        byte[] large = tga(10, 24, 0, new int[12]);
        Arrays.fill(large, 12, 16, (byte) 255);
        assertThat(Raster.ofTga(large)).isNull();
    }

    @Test
    void shouldThrowNothingForAnyBytes() {
        Random random = new Random(7);
        for (int i = 0; i < 20_000; i++) {
            byte[] file = new byte[18 + random.nextInt(60)];
            random.nextBytes(file);
            file[1] &= 1;
            file[2] = (byte) new int[] {1, 2, 3, 9, 10, 11}[random.nextInt(6)];
            file[12] &= 7;
            file[13] = 0;
            file[14] &= 7;
            file[15] = 0;
            file[16] = (byte) new int[] {8, 15, 16, 24, 32}[random.nextInt(5)];
            file[17] &= 0x3f;
            Raster image = Raster.ofTga(file);
            if (image != null) assertThat(image.argb()).hasSize(image.width() * image.height());
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 7, 160})
    void shouldWriteAPngThatOthersRead(int side) throws IOException {
        Random random = new Random(3);
        int[] argb = random.ints(side * (side + 1)).toArray();
        shouldComeBack(new Raster(side, side + 1, argb));
        for (int i = 0; i < argb.length; i++) argb[i] |= 0xff000000;
        shouldComeBack(new Raster(side, side + 1, argb));
    }

    private static void shouldComeBack(Raster image) throws IOException {
        BufferedImage read = ImageIO.read(new ByteArrayInputStream(image.png()));
        assertThat(read.getColorModel().hasAlpha()).isEqualTo(image.hasAlpha());
        assertThat(read.getRGB(0, 0, image.width(), image.height(), null, 0, image.width()))
                .isEqualTo(image.argb());
    }
}
