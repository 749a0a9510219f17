package org.jsmesh.codec;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.Random;
import org.jsmesh.codec.entropy.RangeDecoder;
import org.jsmesh.codec.entropy.RangeEncoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.junit.jupiter.api.Test;

class PreviewCoderTest {
    /** Half a step of luma and of both differences. */
    private static final int FURTHEST = 4 + 6 + 6 + 2;

    @Test
    void shouldComeOutAsTheEncoderSawIt() throws Exception {
        Random random = new Random(1);
        for (int[] side : new int[][] {{8, 8}, {8, 3}, {1, 16}, {1, 1}}) {
            PreviewCoder encoder = new PreviewCoder();
            PreviewCoder decoder = new PreviewCoder();
            for (int stage = 0; stage < 4; stage++) {
                int[] rgb = random.ints((side[0] << stage) * (side[1] << stage), -1, 1 << 24)
                        .toArray();
                byte[] bytes = encode(encoder, side, rgb);
                decoder.codeStage(new RangeDecoder(bytes, 0, bytes.length), 0, 0, null);
                assertThat(decoder.width()).isEqualTo(side[0] << stage);
                assertThat(decoder.height()).isEqualTo(side[1] << stage);
                assertThat(decoder.rgb()).isEqualTo(encoder.rgb());
                assertClose(decoder.rgb(), rgb);
            }
        }
    }

    @Test
    void shouldTakeFewBytesForWhatIsSmooth() throws Exception {
        PreviewCoder coder = new PreviewCoder();
        int bytes = 0;
        for (int side = 8; side <= 64; side *= 2) {
            int[] rgb = new int[side * side];
            for (int i = 0; i < rgb.length; i++) {
                int shade = 255 * (i % side) / side;
                rgb[i] = shade << 16 | shade / 2 << 8 | 255 * (i / side) / side;
            }
            bytes += encode(coder, new int[] {8, 8}, rgb).length;
            assertClose(coder.rgb(), rgb);
        }
        assertThat(bytes).isLessThan(64 * 64 / 4);
    }

    @Test
    void shouldSpendNextToNothingOnWhatNobodySees() throws Exception {
        int[] rgb = new int[64];
        Arrays.fill(rgb, -1);
        rgb[0] = 0xc08040;
        PreviewCoder coder = new PreviewCoder();
        assertThat(encode(coder, new int[] {8, 8}, rgb)).hasSizeLessThan(16);
        assertClose(coder.rgb(), rgb);
    }

    @Test
    void shouldRefuseToGrowWithoutEnd() throws Exception {
        PreviewCoder coder = new PreviewCoder();
        RangeDecoder nothing = new RangeDecoder(new byte[0], 0, 0);
        assertThatThrownBy(() -> {
                    for (int i = 0; i < 10; i++) coder.codeStage(nothing, 0, 0, null);
                })
                .isInstanceOf(MalformedStreamException.class);
        assertThat(Math.max(coder.width(), coder.height())).isLessThanOrEqualTo(PreviewCoder.LARGEST);
    }

    private static byte[] encode(PreviewCoder coder, int[] side, int[] rgb) throws Exception {
        RangeEncoder stream = new RangeEncoder();
        coder.codeStage(stream, side[0], side[1], rgb);
        return stream.finish();
    }

    private static void assertClose(int[] rgb, int[] wanted) {
        for (int i = 0; i < rgb.length; i++) {
            if (wanted[i] < 0) continue;
            for (int shift = 0; shift <= 16; shift += 8)
                assertThat(Math.abs((rgb[i] >> shift & 255) - (wanted[i] >> shift & 255)))
                        .isLessThanOrEqualTo(FURTHEST);
        }
    }
}
