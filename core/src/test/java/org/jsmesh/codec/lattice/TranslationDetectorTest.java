package org.jsmesh.codec.lattice;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TranslationDetectorTest {
    @ParameterizedTest
    @CsvSource({
        "1e6, -.012748, .0117685, -.00641",
        "1e4, 3.25, -.00005, 12.5",
        "10, 1234.5, -77.25, 0",
        "1e6, 0, .01, 0"
    })
    void shouldUndoTheMoveOfDecimals(double scale, float x, float y, float z) {
        float[] offsets = {x, y, z};
        int[] before = decimals(scale);
        int[] moved = before.clone();
        for (int i = 0; i < moved.length; i++) moved[i] = sum(before[i], offsets[i % 3]);
        Translation found = TranslationDetector.undo(moved);
        assertThat(found.isNone()).isFalse();
        for (int i = 0; i < moved.length; i++)
            assertThat(found.moved(i % 3, moved[i])).isEqualTo(sum(before[i], offsets[i % 3]));
        assertThat(LatticeDetector.detect(moved).powers).isEqualTo(RadixPowers.TEN);
    }

    @Test
    void shouldLeaveBinaryNumbersAlone() {
        Random random = new Random(5);
        int[] bits = new int[3000];
        for (int i = 0; i < bits.length; i++) bits[i] = Float.floatToRawIntBits(random.nextFloat() * 100 - 50);
        int[] kept = bits.clone();
        assertThat(TranslationDetector.undo(bits).isNone()).isTrue();
        assertThat(bits).isEqualTo(kept);
    }

    @Test
    void shouldNotBeTakenInByOneOddCoordinate() {
        int[] moved = decimals(1e6);
        for (int i = 0; i < moved.length; i++) moved[i] = sum(moved[i], .0117f);
        moved[100] = Float.floatToRawIntBits(.0123456789f);
        assertThat(TranslationDetector.undo(moved).isNone()).isTrue();
    }

    private static int[] decimals(double scale) {
        Random random = new Random(4);
        int[] bits = new int[3000];
        for (int i = 0; i < bits.length; i++)
            bits[i] = Float.floatToRawIntBits((float) ((random.nextInt(160_000) - 80_000) / scale));
        return bits;
    }

    private static int sum(int bits, float offset) {
        return Float.floatToRawIntBits((float) ((double) Float.intBitsToFloat(bits) + offset));
    }
}
