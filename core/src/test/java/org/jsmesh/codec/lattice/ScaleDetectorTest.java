package org.jsmesh.codec.lattice;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ScaleDetectorTest {
    @ParameterizedTest
    @CsvSource({".01, TEN, 6", ".01, ROUNDED_TEN, 6", ".0254, TEN, 4", "1000, ROUNDED_TEN, 5"})
    void shouldUndoTheMultiplicationOfDecimals(float factor, RadixPowers powers, int digits) {
        int[] before = decimals(powers, digits);
        int[] scaled = before.clone();
        for (int i = 0; i < scaled.length; i++) scaled[i] = product(before[i], factor);
        int[] undone = scaled.clone();
        Translation found = ScaleDetector.undo(undone);
        assertThat(found.isScaled()).isTrue();
        for (int i = 0; i < undone.length; i++)
            assertThat(found.moved(i % 3, undone[i])).isEqualTo(scaled[i]);
        assertThat(LatticeDetector.detect(undone).powers).isNotEqualTo(RadixPowers.TWO);
    }

    @Test
    void shouldLeaveOthersAlone() {
        int[] bits = new Random(5).ints(3000, 0x3f000000, 0x40000000).toArray();
        int[] kept = bits.clone();
        assertThat(ScaleDetector.undo(bits).isNone()).isTrue();
        assertThat(bits).isEqualTo(kept);
    }

    @Test
    void shouldNotBeTakenInByOneOddCoordinate() {
        int[] scaled = decimals(RadixPowers.TEN, 6);
        for (int i = 0; i < scaled.length; i++) scaled[i] = product(scaled[i], .01f);
        scaled[100] = Float.floatToRawIntBits(.0123456789f);
        assertThat(ScaleDetector.undo(scaled).isNone()).isTrue();
    }

    private static int[] decimals(RadixPowers powers, int digits) {
        Random random = new Random(4);
        int most = RadixPowers.TEN.bits(1, digits);
        int[] bits = new int[3000];
        for (int i = 0; i < bits.length; i++) {
            int mantissa = random.nextInt((int) Float.intBitsToFloat(most));
            bits[i] = powers.bits(mantissa, -random.nextInt(5)) | random.nextInt(2) << 31;
        }
        return bits;
    }

    private static int product(int bits, float factor) {
        return Float.floatToRawIntBits((float) ((double) Float.intBitsToFloat(bits) * factor));
    }
}
