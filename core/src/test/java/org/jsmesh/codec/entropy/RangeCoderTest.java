package org.jsmesh.codec.entropy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

class RangeCoderTest {
    @Property(tries = 200, seed = "1")
    void shouldDecodeWhatWasEncoded(@ForAll long seed) {
        int n = (int) (seed & 1023);
        RangeEncoder encoder = new RangeEncoder();
        int[] written = run(encoder, new Random(seed), n, null);
        byte[] bytes = encoder.finish();
        RangeDecoder decoder = new RangeDecoder(bytes, 0, bytes.length);
        run(decoder, new Random(seed), n, written);
        assertThat(decoder.isExhausted()).isFalse();
    }

    /** A random mixture of all operations; a decoder is checked against what was written. */
    private static int[] run(BinaryCoder coder, Random random, int n, int[] written) {
        int[] contexts = BinaryCoder.newContexts(4);
        IntegerModel model = new IntegerModel(2);
        ResidualCoder residuals = new ResidualCoder(1, 0);
        int[] values = new int[n];
        for (int i = 0; i < n; i++) {
            int kind = random.nextInt(6);
            int bits = 1 + random.nextInt(31);
            int value = random.nextInt() >>> 32 - bits;
            int coded = switch (kind) {
                case 0 -> coder.bit(contexts, 0, value = random.nextInt(20) == 0 ? 1 : 0);
                case 1 -> coder.bit(contexts, 1, contexts, 2, value = value & 1);
                case 2 -> coder.raw(value, bits);
                case 3 ->
                    coder.uniform(
                            value,
                            Math.max(1, value) + random.nextInt(5) + 1 < 0
                                    ? Integer.MAX_VALUE
                                    : Math.max(1, value) + 1);
                case 4 -> model.signed(coder, 1, value = random.nextBoolean() ? value : -value);
                default ->
                    residuals.code(
                            coder,
                            0,
                            ResidualCoder.scale(value >>> 3),
                            i % ResidualCoder.SURPRISES,
                            i % 3 - 1,
                            value = random.nextBoolean() ? value : -value);
            };
            values[i] = coded;
            if (written == null) assertThat(coded).isEqualTo(value);
            else assertThat(coded).as("value %d of kind %d", i, kind).isEqualTo(written[i]);
        }
        return values;
    }

    @org.junit.jupiter.api.Test
    void shouldCostNextToNothingForWhatIsCertain() {
        RangeEncoder encoder = new RangeEncoder();
        int[] contexts = BinaryCoder.newContexts(1);
        for (int i = 0; i < 10_000; i++) encoder.bit(contexts, 0, 0);
        assertThat(encoder.finish().length).isLessThan(30);
    }

    @Property(tries = 100, seed = "2")
    void shouldDecodeAnyBytesToValuesInRange(@ForAll byte[] bytes) {
        RangeDecoder decoder = new RangeDecoder(bytes, 0, bytes.length);
        IntegerModel model = new IntegerModel(1);
        for (int i = 0; i < 200; i++) {
            assertThat(decoder.uniform(0, 1 + i * 7919)).isBetween(0, i * 7919);
            assertThat(model.unsigned(decoder, 0)).isNotNegative();
        }
    }
}
