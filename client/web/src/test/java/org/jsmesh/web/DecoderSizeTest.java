package org.jsmesh.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * A slow connection waits for the decoders: they stay small. Where one grows, {@code docs/developing.md} tells how to
 * see what of the class library is new in it.
 */
class DecoderSizeTest {
    @ParameterizedTest
    @CsvSource({
        "first-decoder.js, 165_000, 63_000",
        "decoder.wasm, 235_000, 108_000",
        "decoder.js, 250_000, 98_000",
        "workshop.wasm, 790_000, 345_000"
    })
    void shouldStaySmall(String file, String mostBytes, String mostCompressed) throws IOException {
        byte[] bytes = read(file);
        assertThat(bytes).hasSizeBetween(50_000, number(mostBytes));
        assertThat(compressed(bytes)).isLessThan(number(mostCompressed));
    }

    private static int number(String digits) {
        return Integer.parseInt(digits.replace("_", ""));
    }

    private static byte[] read(String file) throws IOException {
        return Files.readAllBytes(Path.of("target/decoder", file));
    }

    private static int compressed(byte[] bytes) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (GZIPOutputStream gzip = new GZIPOutputStream(out)) {
            gzip.write(bytes);
        }
        return out.size();
    }
}
