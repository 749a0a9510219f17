package org.jsmesh.codec;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.jsmesh.codec.entropy.RangeDecoder;
import org.jsmesh.codec.entropy.RangeEncoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.junit.jupiter.api.Test;

class PreviewCoderTest {
    private static final int OPAQUE = 0xff000000;

    @Test
    void shouldComeOutAsTheEncoderSawIt() throws Exception {
        Random random = new Random(1);
        for (boolean alpha : new boolean[] {false, true})
            for (int[] side : new int[][] {{8, 8}, {8, 3}, {1, 16}, {1, 1}}) {
                PreviewCoder encoder = new PreviewCoder(new PreviewModel());
                PreviewCoder decoder = new PreviewCoder(new PreviewModel());
                for (int stage = 0; stage < 5; stage++) {
                    int pixels = (side[0] << stage) * (side[1] << stage);
                    boolean[] free = new boolean[pixels];
                    for (int i = 0; i < pixels; i++) free[i] = random.nextInt(3) == 0;
                    PreviewCoder.Wanted wanted = new PreviewCoder.Wanted(
                            side[0] << stage,
                            side[1] << stage,
                            1 + random.nextInt(32),
                            alpha,
                            random.ints(pixels).toArray(),
                            free);
                    int most = 20 + random.nextInt(200);
                    for (byte[] portion : encode(encoder, wanted, most)) decode(decoder, portion);
                    assertThat(decoder.width()).isEqualTo(side[0] << stage);
                    assertThat(decoder.height()).isEqualTo(side[1] << stage);
                    assertThat(decoder.argb()).isEqualTo(encoder.argb());
                }
            }
    }

    @Test
    void shouldShowAStageWhenItsLastRowIsThere() throws Exception {
        PreviewCoder encoder = new PreviewCoder(new PreviewModel());
        PreviewCoder decoder = new PreviewCoder(new PreviewModel());
        for (byte[] portion : encode(encoder, opaque(8, 1, noise(8)), 1 << 20)) decode(decoder, portion);
        List<byte[]> portions = encode(encoder, opaque(16, 1, noise(16)), 100);
        assertThat(portions).hasSizeGreaterThan(3);
        for (byte[] portion : portions) {
            assertThat(decoder.width()).isEqualTo(8);
            assertThat(portion.length).isLessThan(250);
            decode(decoder, portion);
        }
        assertThat(decoder.width()).isEqualTo(16);
        assertThat(decoder.argb()).isEqualTo(encoder.argb());
    }

    @Test
    void shouldComeCloserStageByStage() throws Exception {
        PreviewCoder coder = new PreviewCoder(new PreviewModel());
        int bytes = 0;
        for (int side = 8; side <= 128; side *= 2) {
            int[] rgb = new int[side * side];
            for (int i = 0; i < rgb.length; i++) {
                int shade = 255 * (2 * (i % side) + 1) / (2 * side);
                rgb[i] = shade << 16 | shade / 2 << 8 | 255 * (2 * (i / side) + 1) / (2 * side);
            }
            for (byte[] portion : encode(coder, opaque(side, 4, rgb), 1 << 20)) bytes += portion.length;
            assertThat(meanDifference(coder.argb(), rgb)).as("side %d", side).isLessThan(10);
        }
        assertThat(bytes).isLessThan(1200);
    }

    @Test
    void shouldSpendNextToNothingOnWhatNobodySees() throws Exception {
        boolean[] free = new boolean[64];
        Arrays.fill(free, true);
        free[0] = false;
        int[] argb = new int[64];
        argb[0] = OPAQUE | 0xc08040;
        PreviewCoder coder = new PreviewCoder(new PreviewModel());
        List<byte[]> portions = encode(coder, new PreviewCoder.Wanted(8, 8, 4, false, argb, free), 1 << 20);
        assertThat(portions).singleElement().satisfies(p -> assertThat(p).hasSizeLessThan(16));
        assertThat(meanDifference(Arrays.copyOf(coder.argb(), 1), new int[] {0xc08040}))
                .isLessThan(6);
    }

    @Test
    void shouldKeepOpacityWhereItIsWanted() throws Exception {
        int[] argb = new int[64];
        for (int i = 0; i < argb.length; i++) argb[i] = i % 8 < 4 ? 0x00ffffff : 0xff206040;
        PreviewCoder coder = new PreviewCoder(new PreviewModel());
        encode(coder, new PreviewCoder.Wanted(8, 8, 8, true, argb, new boolean[64]), 1 << 20);
        for (int i = 0; i < argb.length; i++)
            assertThat(coder.argb()[i] >>> 24).isBetween(i % 8 < 4 ? 0 : 245, i % 8 < 4 ? 10 : 255);
        PreviewCoder other = new PreviewCoder(new PreviewModel());
        encode(other, new PreviewCoder.Wanted(8, 8, 8, false, argb, new boolean[64]), 1 << 20);
        for (int pixel : other.argb()) assertThat(pixel >>> 24).isEqualTo(255);
    }

    @Test
    void shouldRefuseToGrowWithoutEnd() throws Exception {
        PreviewCoder coder = new PreviewCoder(new PreviewModel());
        for (int width = 1; width <= 32; width *= 2) encode(coder, grey(width), 1 << 20);
        assertThat(coder.height()).isEqualTo(PreviewCoder.LARGEST);
        assertThatThrownBy(() -> encode(coder, grey(64), 1 << 20))
                .isInstanceOf(MalformedStreamException.class)
                .hasMessageContaining("512");
    }

    private static List<byte[]> encode(PreviewCoder coder, PreviewCoder.Wanted wanted, int most) throws Exception {
        List<byte[]> portions = new ArrayList<>();
        do {
            RangeEncoder stream = new RangeEncoder();
            coder.codePortion(stream, wanted, () -> stream.estimatedBytes() > most);
            portions.add(stream.finish());
        } while (coder.isAmidStage());
        return portions;
    }

    private static void decode(PreviewCoder coder, byte[] portion) throws Exception {
        coder.codePortion(new RangeDecoder(portion, 0, portion.length), null, () -> false);
    }

    private static PreviewCoder.Wanted grey(int width) {
        return new PreviewCoder.Wanted(
                width, 16 * width, 8, false, new int[16 * width * width], new boolean[16 * width * width]);
    }

    private static int[] noise(int side) {
        return new Random(2).ints(side * side, 0, 1 << 24).toArray();
    }

    private static PreviewCoder.Wanted opaque(int side, int step, int[] rgb) {
        int[] argb = rgb.clone();
        for (int i = 0; i < argb.length; i++) argb[i] |= OPAQUE;
        return new PreviewCoder.Wanted(side, side, step, false, argb, new boolean[argb.length]);
    }

    private static double meanDifference(int[] there, int[] wanted) {
        double sum = 0;
        for (int i = 0; i < there.length; i++)
            for (int shift = 0; shift <= 16; shift += 8)
                sum += Math.abs((there[i] >> shift & 255) - (wanted[i] >> shift & 255)) / 3.0;
        return sum / there.length;
    }
}
