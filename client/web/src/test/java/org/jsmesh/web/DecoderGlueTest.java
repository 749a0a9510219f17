package org.jsmesh.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.List;
import org.jsmesh.mesh.Sha256;
import org.jsmesh.web.testing.Browser;
import org.jsmesh.web.testing.PageServer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.teavm.model.ClassHolderTransformer;

/** {@code decoder-wasm.js} stands in for TeaVM's own loader. */
class DecoderGlueTest {
    private static final String RUNTIME = "/org/teavm/backend/wasm/wasm-gc-module-runtime.js";

    @TempDir
    static Path profile;

    /**
     * When this fails, another version of TeaVM has another loader: compare it with the one before, change
     * {@code decoder-wasm.js} where the difference concerns what it gives, and then the hash here.
     */
    @Test
    void shouldStandInForTheLoaderOfThisVersion() throws IOException {
        try (InputStream in = ClassHolderTransformer.class.getResourceAsStream(RUNTIME)) {
            assertThat(in).as(RUNTIME).isNotNull();
            assertThat(Sha256.hex(in.readAllBytes()))
                    .isEqualTo("05a76aaced9113a89533c1b6609e19dcb2a484bb7f20593f4980e0cfbb6b9787");
        }
    }

    /** Nothing lacks, and nothing is there for its own sake. */
    @Test
    void shouldGiveExactlyWhatTheDecoderImports() throws IOException {
        try (Browser browser = new Browser(profile);
                PageServer server = new PageServer()) {
            server.put("/blank.html", "<!doctype html><title>decoder</title><link rel=icon href=data:,>".getBytes());
            browser.open(server.address("/blank.html"));
            List<?> differences = (List<?>) browser.call("""
                    const { compile, glueOf } = await import('/modules/decode/decoder-wasm.js');
                    const module = await compile(new URL('/modules/decoder/decoder.wasm', location.href));
                    const asked = WebAssembly.Module.imports(module).map(({ module, name }) => `${module}.${name}`);
                    const parts = Object.entries(glueOf(module, () => null));
                    const given = parts.flatMap(([part, glue]) => Object.keys(glue).map((name) => `${part}.${name}`));
                    return [
                      ...asked.filter((name) => !given.includes(name)).map((name) => `lacks ${name}`),
                      ...given.filter((name) => !asked.includes(name)).map((name) => `gives ${name}`),
                    ];
                    """);
            assertThat(differences).isEmpty();
        }
    }
}
