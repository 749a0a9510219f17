package org.jsmesh.memory;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Random;
import java.util.zip.GZIPOutputStream;
import org.assertj.core.data.Percentage;
import org.jsmesh.encode.EncoderSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A gzip file says the length of what it holds modulo 4 GiB. No byte of these is on a disk. */
class PackedLengthTest {
    @ParameterizedTest
    @ValueSource(longs = {1_000_000, 105_000_000, 200_000_000, 400_000_000})
    void shouldBelieveABinaryStlFileHowManyFacetsItHas(long facets) throws IOException {
        byte[] start = new byte[84 + 50 * 2000];
        new Random(1).nextBytes(start);
        ByteBuffer.wrap(start).order(ByteOrder.LITTLE_ENDIAN).putInt(80, (int) facets);
        long unpacked = 84 + 50 * facets;
        MemoryEstimate found = packed("a.stl.gz", start, unpacked, (long) (unpacked / 5.5));
        assertThat(found.faces()).isEqualTo(facets);
        assertThat(found.leastBytes()).isPositive();
    }

    @ParameterizedTest
    @ValueSource(longs = {1L << 30, 3L << 30, 5L << 30, 6L << 30, 11L << 30, 20L << 30})
    void shouldTellTheLengthOfTextByWhatIsPackedAtItsBeginning(long unpacked) throws IOException {
        StringBuilder text = new StringBuilder("solid a\n");
        Random random = new Random(1);
        while (text.length() < 1 << 18) {
            text.append("facet normal 0 0 1\nouter loop\n");
            for (int c = 0; c < 3; c++)
                text.append("vertex ")
                        .append(random.nextInt(100))
                        .append(" 0.25 ")
                        .append(random.nextInt(1000))
                        .append('\n');
            text.append("endloop\nendfacet\n");
        }
        byte[] start = text.toString().getBytes(StandardCharsets.US_ASCII);
        double facets = (double) unpacked / start.length * (text.toString().split("endfacet").length - 1);
        double ratio = (double) start.length / gzip(start).length;
        assertThat(ratio).isGreaterThan(4.5);
        MemoryEstimate found = packed("a.stl.gz", start, unpacked, (long) (unpacked / ratio));
        assertThat((double) found.faces()).isCloseTo(facets, Percentage.withPercentage(5));
        assertThat(found.leastBytes()).isZero();
    }

    @Test
    void shouldMeasureManyPartsTogether() throws IOException {
        byte[] part = new byte[20_000];
        new Random(1).nextBytes(part);
        ByteArrayOutputStream parts = new ByteArrayOutputStream();
        for (int i = 0; i < 500; i++) parts.write(gzip(part));
        parts.write(gzip(new byte[0]));
        byte[] all = parts.toByteArray();
        MemoryEstimate found =
                MemoryEstimate.of("a.stl.gz", all.length, ByteRanges.ofStart(all), EncoderSettings.defaults());
        assertThat(found.faces()).isCloseTo(4 * 500 * 20_000 / 50, Percentage.withPercentage(2));
    }

    private static MemoryEstimate packed(String name, byte[] start, long unpacked, long packed) throws IOException {
        byte[] beginning = gzip(start);
        ByteRanges content = (from, bytes) -> {
            byte[] read = new byte[(int) Math.min(bytes, packed - from)];
            for (int i = 0; i < read.length; i++) {
                long at = from + i;
                if (at >= packed - 4) read[i] = (byte) (unpacked >> 8 * (at - packed + 4));
                else if (at < beginning.length) read[i] = beginning[(int) at];
            }
            return read;
        };
        return MemoryEstimate.of(name, packed, content, EncoderSettings.defaults());
    }

    private static byte[] gzip(byte[] content) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (GZIPOutputStream out = new GZIPOutputStream(bytes)) {
            out.write(content);
        }
        return bytes.toByteArray();
    }
}
