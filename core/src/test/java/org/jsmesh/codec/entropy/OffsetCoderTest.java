package org.jsmesh.codec.entropy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class OffsetCoderTest {
    private static final int COUNT = 4000;

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 7, 20, 28})
    void shouldGiveBackOffsetsWhateverIsPredicted(int bits) {
        RangeEncoder encoder = new RangeEncoder();
        int[] written = run(encoder, bits, 1 << 28, null);
        byte[] bytes = encoder.finish();
        run(new RangeDecoder(bytes, 0, bytes.length), bits, 1 << 28, written);
    }

    @Test
    void shouldSaveWhatIsForetold() {
        RangeEncoder encoder = new RangeEncoder();
        run(encoder, 12, 2, null);
        assertThat(8.0 * encoder.finish().length / COUNT).isBetween(2.0, 3.5);
    }

    @Test
    void shouldKnowWhatPredictionsSave() {
        OffsetCoder offsets = new OffsetCoder(1);
        RangeEncoder encoder = new RangeEncoder();
        offsets.startCounting();
        for (int i = 0; i < 500; i++) offsets.code(encoder, 0, 700, 10, 700);
        assertThat(offsets.settle()).isBetween(4000, 5000);
        offsets.startCounting();
        Random random = new Random(2);
        for (int i = 0; i < 500; i++) offsets.code(encoder, 0, random.nextInt(1024), 10, random.nextInt(1024));
        assertThat(offsets.settle()).isLessThan(50);
    }

    @Test
    void shouldLeaveRawWhatPredictionsDoNotForetell() {
        OffsetCoder offsets = new OffsetCoder(1);
        offsets.startCounting();
        codeWithNoise(offsets, new RangeEncoder());
        int saved = offsets.settle();
        assertThat(saved).isBetween(1500, 2500); // of the 4 upper bits, 500 times
        RangeEncoder settled = new RangeEncoder();
        codeWithNoise(offsets, settled);
        assertThat(8 * settled.finish().length).isBetween(500 * 6 - 50, 500 * 6 + 700);
    }

    /** Values of 10 bits, of which the upper 4 are foretold. */
    private static void codeWithNoise(OffsetCoder offsets, RangeEncoder encoder) {
        Random random = new Random(3);
        for (int i = 0; i < 500; i++) offsets.code(encoder, 0, 700, 10, 700 & ~63 | random.nextInt(64));
    }

    /** Predictions are off by less than {@code error}. */
    private static int[] run(BinaryCoder coder, int bits, int error, int[] written) {
        OffsetCoder offsets = new OffsetCoder(2);
        Random random = new Random(7);
        int[] values = new int[COUNT];
        for (int i = 0; i < COUNT; i++) {
            int offset = random.nextInt(1 << bits);
            int predicted = offset + random.nextInt(2 * error) - error;
            boolean same = random.nextInt(5) == 0;
            assertThat(offsets.codeSame(coder, 1 + i % 6, written == null && same))
                    .isEqualTo(same);
            values[i] = offsets.code(coder, i & 1, predicted, bits, written == null ? offset : 0);
            if (written != null) assertThat(values[i]).isEqualTo(written[i]);
        }
        return values;
    }
}
