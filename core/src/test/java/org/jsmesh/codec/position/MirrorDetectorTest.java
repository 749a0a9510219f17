package org.jsmesh.codec.position;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.jsmesh.codec.lattice.Lattice;
import org.jsmesh.codec.lattice.LatticeDetector;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MirrorDetectorTest {
    private static final int PAIRS = 400;

    @ParameterizedTest
    @CsvSource({"0, 0", "1, 0", "2, 0", "0, 1.25", "1, -.004", "2, .00049"})
    void shouldFindThePlaneOfPairs(int axis, float sum) {
        int[] bits = pairs(axis, sum, 1);
        Lattice lattice = LatticeDetector.detect(bits);
        Mirror mirror = MirrorDetector.detect(bits, lattice);
        assertThat(mirror).isEqualTo(new Mirror(axis, Float.floatToIntBits(sum)));
        assertThat(mirror.isExact()).isEqualTo(sum == 0);
        for (int v = 0; v < bits.length; v += 6) {
            assertThat(mirror.bits(bits[v + axis], lattice)).isEqualTo(bits[v + 3 + axis]);
            assertThat(mirror.bits(bits[v + 3 + axis], lattice)).isEqualTo(bits[v + axis]);
        }
    }

    @Test
    void shouldFindThePlaneOfAFewPairsAmongOthers() {
        int[] bits = pairs(1, 2, .2);
        assertThat(MirrorDetector.detect(bits, LatticeDetector.detect(bits)))
                .isEqualTo(new Mirror(1, Float.floatToIntBits(2)));
    }

    @Test
    void shouldSayThatThereIsNone() {
        int[] bits = pairs(1, 2, .02);
        assertThat(MirrorDetector.detect(bits, LatticeDetector.detect(bits)).isNone())
                .isTrue();
    }

    /** Vertices, of which a share has the next one for its image. */
    private static int[] pairs(int axis, double sum, double share) {
        Random random = new Random(8);
        int[] bits = new int[6 * PAIRS];
        for (int v = 0; v < bits.length; v += 6) {
            double[] at = new double[3];
            for (int a = 0; a < 3; a++) at[a] = (random.nextInt(20_000) - 10_000) / 1e5 + 5;
            for (int a = 0; a < 3; a++) bits[v + a] = Float.floatToIntBits((float) (Math.rint(at[a] * 1e5) / 1e5));
            boolean isPair = random.nextDouble() < share;
            if (isPair) at[axis] = sum - at[axis];
            else at[axis] += .1;
            for (int a = 0; a < 3; a++) bits[v + 3 + a] = Float.floatToIntBits((float) (Math.rint(at[a] * 1e5) / 1e5));
        }
        return bits;
    }
}
