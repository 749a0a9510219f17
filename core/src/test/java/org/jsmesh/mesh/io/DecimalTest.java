package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class DecimalTest {
    private final Decimal decimal = new Decimal();

    private boolean scan(String text) {
        byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
        return decimal.scan(bytes, 0, bytes.length);
    }

    private void check(String text) {
        assertThat(scan(text)).as(text).isTrue();
        assertThat(Float.floatToRawIntBits(decimal.toFloat()))
                .as(text)
                .isEqualTo(Float.floatToRawIntBits(Float.parseFloat(text)));
        assertThat(Double.doubleToRawLongBits(decimal.toDouble()))
                .as(text)
                .isEqualTo(Double.doubleToRawLongBits(Double.parseDouble(text)));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "0",
                "-0",
                "-0.0",
                "0e99999999999999999999",
                "1",
                "+1",
                ".5",
                "5.",
                "-3.061516E-16",
                "1e-45",
                "7e-46",
                "1.1754943e-38",
                "3.4028236e38",
                "1e39",
                "-1e400",
                "1e-400",
                "16777217",
                "16777217.0000001",
                "0.1",
                "123456789012345678901234567890",
                "8.50706e-39",
                "1.00000005960464477539",
                "1.000000059604644775390625",
                "1.0000000596046447753906251",
                "0000000000000000000000000000001.5",
                "0.000000000000000000000000000000000000123"
            })
    void shouldReadWhatJavaReads(String text) {
        check(text);
    }

    @Test
    void shouldRoundEveryRandomNumberCorrectly() {
        Random random = new Random(7);
        for (int i = 0; i < 100_000; i++) {
            float value = Float.intBitsToFloat(random.nextInt());
            if (Float.isNaN(value) || Float.isInfinite(value)) continue;
            check(Float.toString(value));
            check(Double.toString((double) value * (1 + random.nextInt(3) * 0x1p-52)));
            check(random.nextLong() + "e" + (random.nextInt(120) - 60));
        }
    }

    @Test
    void shouldRoundTiesBetweenFloatsCorrectly() {
        Random random = new Random(8);
        for (int i = 0; i < 20_000; i++) {
            float low = Float.intBitsToFloat(random.nextInt(0x7F000000));
            double tie = ((double) low + (double) Math.nextUp(low)) / 2;
            String text = new java.math.BigDecimal(tie).toPlainString();
            check(text);
            check(text.contains(".") ? text + "0001" : text + ".0001");
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "+",
                "-",
                ".",
                "e5",
                "1e",
                "1e+",
                "1.2.3",
                "1f",
                "0x1p3",
                "NaN",
                "Infinity",
                "1,5",
                "--1",
                "1 "
            })
    void shouldRefuseWhatIsNoDecimalNumber(String text) {
        assertThat(scan(text)).isFalse();
    }

    @ParameterizedTest
    @ValueSource(strings = {"%.9g", "%.6f", "%.3e", "%.10f", "%.17e", "%.1f", "%.30f"})
    void shouldBeHeldByFloatWhateverAProgramPrintedOfOne(String format) {
        java.util.Random random = new java.util.Random(4);
        for (int i = 0; i < 3000; i++) {
            float x = (float) (random.nextGaussian() * StrictMath.pow(10, random.nextInt(8) - 4));
            String text = String.format(java.util.Locale.ROOT, format, x);
            assertThat(isHeld(text)).as(text).isTrue();
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"450000.123", "123.456789", "16777217", "0.12345678901234567", "1.5e-60", "1.234567e-41"})
    void shouldNotBeHeldByFloatWhereDigitsAreLost(String text) {
        assertThat(isHeld(text)).isFalse();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "0",
                "-0.0",
                "0.1",
                "1.38778e-17",
                "2.5e-21",
                "16777216",
                "1e30",
                "1e-41",
                "1.4E-45",
                "1.17549421E-38"
            })
    void shouldBeHeldByFloatWhereNoDigitIsLost(String text) {
        assertThat(isHeld(text)).isTrue();
    }

    private boolean isHeld(String text) {
        assertThat(scan(text)).isTrue();
        return decimal.isHeldByFloat();
    }
}
