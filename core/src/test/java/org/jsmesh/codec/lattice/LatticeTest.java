package org.jsmesh.codec.lattice;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.jsmesh.codec.entropy.RangeDecoder;
import org.jsmesh.codec.entropy.RangeEncoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.junit.jupiter.api.Test;

class LatticeTest {
    @Test
    void shouldFindSignificantDigits() {
        Lattice lattice = LatticeDetector.detect(column("%.4e", 1000, 3));
        assertThat(lattice.powers).isEqualTo(RadixPowers.TEN);
        assertThat(lattice.digits).isEqualTo(5);
    }

    @Test
    void shouldFindFixedDecimals() {
        Lattice lattice = LatticeDetector.detect(column("%.3f", 1000, 3));
        assertThat(lattice.powers).isEqualTo(RadixPowers.TEN);
        assertThat(lattice.minExponent).isEqualTo(-3);
    }

    /** 12.340 was read as 1234 times the float32 number closest to a hundredth. */
    @Test
    void shouldFindDecimalsThatWereReadInFloat32() throws Exception {
        Random random = new Random(6);
        int[] bits = new int[1000];
        for (int i = 0; i < bits.length; i++) {
            int mantissa = random.nextInt(100_000);
            int zeros = mantissa % 10 > 0 ? 0 : mantissa % 100 > 0 ? 1 : mantissa % 1000 > 0 ? 2 : 3;
            float power = new float[] {1e-5f, 1e-4f, 1e-3f, 1e-2f}[zeros];
            bits[i] = Float.floatToIntBits(mantissa / new int[] {1, 10, 100, 1000}[zeros] * power);
        }
        Lattice lattice = LatticeDetector.detect(bits);
        assertThat(lattice.powers).isEqualTo(RadixPowers.ROUNDED_TEN);
        assertThat(lattice.digits).isEqualTo(5);
        assertThat(lattice.hasExceptions).isFalse();
        assertRoundTrip(lattice, bits);
    }

    @Test
    void shouldFallBackToFloat32() {
        Random random = new Random(1);
        int[] bits = random.ints(1000, 0x3f000000, 0x40000000).toArray();
        Lattice lattice = LatticeDetector.detect(bits);
        assertThat(lattice.powers).isEqualTo(RadixPowers.TWO);
        assertThat(lattice.hasExceptions).isFalse();
    }

    @Test
    void shouldTolerateAFewOddValues() throws Exception {
        int[] bits = column("%.3f", 4000, 3);
        bits[17] = Float.floatToIntBits(1.23456789f);
        Lattice lattice = LatticeDetector.detect(bits);
        assertThat(lattice.powers).isEqualTo(RadixPowers.TEN);
        assertThat(lattice.hasExceptions).isTrue();
        assertRoundTrip(lattice, bits);
    }

    @Test
    void shouldNumberItsPointsWithoutGaps() {
        for (Lattice lattice : new Lattice[] {
            new Lattice(RadixPowers.TEN, 3, -6, 1, false),
            new Lattice(RadixPowers.ROUNDED_TEN, 3, -6, 1, false),
            new Lattice(RadixPowers.TWO, 24, -18, 3, false)
        }) {
            LatticePoint point = new LatticePoint();
            double last = 0;
            for (int i = 0; lattice.bitsAt(i) < Float.floatToIntBits(8); i += 1 + i / 1000) {
                int bits = lattice.bitsAt(i);
                assertThat(point.find(lattice.powers, lattice.digits, lattice.minExponent, bits))
                        .isTrue();
                assertThat(lattice.index(point.mantissa, point.exponent)).isEqualTo(i);
                assertThat((double) Float.intBitsToFloat(bits)).isGreaterThanOrEqualTo(last);
                last = Float.intBitsToFloat(bits);
            }
            assertThat(last).isGreaterThan(7);
        }
    }

    @Test
    void shouldFindTheClosestPoint() {
        Lattice lattice = new Lattice(RadixPowers.TEN, 3, -6, -2, false);
        double[] numbers = {0, 1.2349, -1.2351, .12345, -.00012349, 1e-9, 42, -1e30};
        float[] closest = {0, 1.23f, -1.24f, .123f, -.000123f, 0, 9.99f, -9.99f};
        for (int i = 0; i < numbers.length; i++)
            assertThat(Float.intBitsToFloat(lattice.closest(numbers[i]))).isEqualTo(closest[i]);
    }

    @Test
    void shouldPayFewBitsForValuesBetweenItsPoints() throws Exception {
        int[] bits = column("%.6f", 4000, 1);
        Random random = new Random(5);
        for (int i = 0; i < bits.length; i += 10) bits[i] += random.nextInt(7) - 3;
        Lattice lattice = LatticeDetector.detect(bits);
        assertThat(lattice.powers).isEqualTo(RadixPowers.TEN);
        assertRoundTrip(lattice, bits);
    }

    @Test
    void shouldGiveBackTheBitsOfEveryKindOfColumn() throws Exception {
        assertRoundTrip(column("%.4e", 2000, 3));
        assertRoundTrip(column("%.6f", 2000, .01));
        assertRoundTrip(column("%.2e", 2000, 1e-12));
        assertRoundTrip(column("%.0f", 2000, 1e6));
        assertRoundTrip(new int[] {0, 0x80000000, 1, 0x80000001, 0x7f7fffff, 0xff7fffff});
        assertRoundTrip(new int[] {});
        assertRoundTrip(new int[] {0, 0});
        Random random = new Random(2);
        int[] any = random.ints(5000)
                .map(i -> (i & 0x7f800000) == 0x7f800000 ? i & 0x8fffffff : i)
                .toArray();
        assertRoundTrip(any);
        int[] eighths = random.ints(500, -100, 100)
                .map(i -> Float.floatToIntBits(i / 8f))
                .toArray();
        assertRoundTrip(eighths);
    }

    private static int[] column(String format, int n, double scale) {
        Random random = new Random(5);
        int[] bits = new int[n];
        for (int i = 0; i < n; i++)
            bits[i] = Float.floatToIntBits(
                    Float.parseFloat(String.format(java.util.Locale.ROOT, format, random.nextGaussian() * scale)));
        return bits;
    }

    private static void assertRoundTrip(int[] bits) throws MalformedStreamException {
        assertRoundTrip(LatticeDetector.detect(bits), bits);
    }

    private static void assertRoundTrip(Lattice lattice, int[] bits) throws MalformedStreamException {
        RangeEncoder encoder = new RangeEncoder();
        LatticeCoder writer = new LatticeCoder(lattice);
        int[] cells = new int[bits.length];
        for (int i = 0; i < bits.length; i++) {
            cells[i] = writer.cell(bits[i]);
            assertThat(cells[i]).isBetween(-lattice.cellLimit(), lattice.cellLimit() - 1);
            writer.code(encoder, cells[i], bits[i]);
        }
        byte[] bytes = encoder.finish();
        RangeDecoder decoder = new RangeDecoder(bytes, 0, bytes.length);
        LatticeCoder reader = new LatticeCoder(lattice);
        for (int i = 0; i < bits.length; i++)
            assertThat(reader.code(decoder, cells[i], 0))
                    .as("value %d of %s", i, lattice)
                    .isEqualTo(bits[i]);
    }
}
