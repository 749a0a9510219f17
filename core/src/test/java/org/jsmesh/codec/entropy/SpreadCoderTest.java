package org.jsmesh.codec.entropy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;

class SpreadCoderTest {
    private static final int BITS = 12;
    private static final int COUNT = 1000;

    @Test
    void shouldGiveBackOffsetsWhateverWasForetold() throws Exception {
        double[] foretold = {0, -1e9, 1e9, 2048, 4095.5, -3, 1e-9, 5000};
        double[] sizes = {.25, 1e-6, 1e9, 30};
        RangeEncoder encoder = new RangeEncoder();
        SpreadCoder coder = new SpreadCoder(1);
        for (int i = 0; i < COUNT; i++) coder.code(encoder, 0, foretold[i % 8], sizes[i / 8 % 4], BITS, i * 37 & 4095);
        byte[] bytes = encoder.finish();
        RangeDecoder decoder = new RangeDecoder(bytes, 0, bytes.length);
        SpreadCoder back = new SpreadCoder(1);
        for (int i = 0; i < COUNT; i++)
            assertThat(back.code(decoder, 0, foretold[i % 8], sizes[i / 8 % 4], BITS, 0))
                    .isEqualTo(i * 37 & 4095);
    }

    @Test
    void shouldSpendLittleOnWhatIsCloseToWhereItIsExpected() throws Exception {
        assertThat(bitsPerOffset(4)).isLessThan(5);
        assertThat(bitsPerOffset(64)).isLessThan(9);
        assertThat(bitsPerOffset(1e6)).isBetween(11.9, 12.3);
    }

    private static double bitsPerOffset(double distance) {
        Random random = new Random(3);
        RangeEncoder encoder = new RangeEncoder();
        SpreadCoder coder = new SpreadCoder(1);
        for (int i = 0; i < COUNT; i++) {
            int offset = random.nextInt(1 << BITS);
            coder.code(encoder, 0, offset + .5 + distance * random.nextGaussian(), distance, BITS, offset);
        }
        return encoder.finish().length * 8.0 / COUNT;
    }
}
