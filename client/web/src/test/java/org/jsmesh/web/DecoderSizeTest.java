package org.jsmesh.web;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.zip.GZIPOutputStream;
import org.jsmesh.test.results.RecordedResults;
import org.jsmesh.test.results.ResultColumn;
import org.jsmesh.test.results.ResultTable;
import org.junit.jupiter.api.Test;

/**
 * A slow connection waits for the decoders: they stay as small as they are recorded. Where one grows,
 * {@code docs/developing.md} tells how to see what of the class library is new in it.
 */
class DecoderSizeTest {
    private static final List<String> FILES =
            List.of("first-decoder.js", "decoder.wasm", "decoder.js", "workshop.wasm");
    private static final String COMMAND =
            "mvn -q -pl client/web -am test -Dtest=DecoderSizeTest -Dsurefire.failIfNoSpecifiedTests=false";

    @Test
    void shouldStaySmall() throws IOException {
        ResultTable sizes =
                new ResultTable("file", List.of(ResultColumn.small("bytes"), ResultColumn.small("compressed")));
        for (String file : FILES) {
            byte[] bytes = Files.readAllBytes(Path.of("target/decoder", file));
            sizes.put(file, bytes.length, compressed(bytes));
        }
        new RecordedResults("Decoders of the page", COMMAND).check(sizes);
    }

    private static int compressed(byte[] bytes) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (GZIPOutputStream gzip = new GZIPOutputStream(out)) {
            gzip.write(bytes);
        }
        return out.size();
    }
}
