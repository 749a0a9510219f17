package org.jsmesh.web.build;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PackageBuildTest {
    @TempDir
    private Path folder;

    @BeforeEach
    void writeSources() throws IOException {
        write("sources/three/jsm-loader.js", """
                import { Loader } from 'three';
                import { worker } from '../session/pool.js';
                export class JsmLoader extends Loader { worker = worker; }
                """);
        write("sources/viewer/jsm-viewer.js", """
                import { worker } from '../session/pool.js';
                console.log(worker);
                import('../three/stage.js');
                """);
        write(
                "sources/three/stage.js",
                "import { Orbit } from 'three/addons/controls/Orbit.js';\nconsole.log(Orbit);\n");
        write("sources/session/pool.js", "export const worker = new URL('../decode/worker.js', import.meta.url);\n");
        write("sources/decode/worker.js", """
                /** @typedef {typeof import('../decoder/decoder.js')} Java */
                import { part } from './part.js';
                part(fetch(new URL('../decoder/decoder.wasm', import.meta.url)), async () => await import('../decoder/decoder.js'));
                """);
        write("sources/decode/part.js", "export const part = console.log;\n");
        write("decoder/decoder.wasm", "wasm");
        write("decoder/decoder.js", "export const decoder = 1;\n");
        Files.createDirectories(folder.resolve("package"));
    }

    private void write(String name, String text) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
    }

    private void build() throws IOException {
        PackageBuild.main(new String[] {
            folder.resolve("sources").toString(),
            folder.resolve("decoder").toString(),
            folder.resolve("work").toString(),
            folder.resolve("package").toString(),
            folder.resolve("package.tgz").toString()
        });
    }

    private String text(String name) throws IOException {
        return Files.readString(folder.resolve("package").resolve(name));
    }

    @Test
    void shouldLeaveThreeToWhoeverUsesThePackage() throws IOException {
        build();
        assertThat(text("jsm-loader.js")).contains("from \"three\";");
        Path stage = Folders.files(folder.resolve("package")).stream()
                .filter(file -> file.getFileName().toString().startsWith("stage-"))
                .findFirst()
                .orElseThrow();
        assertThat(stage).content().contains("from \"three/addons/controls/Orbit.js\";");
    }

    @Test
    void shouldNameWorkerAndDecoderBesideTheModules() throws IOException {
        build();
        assertThat(text("jsm-worker.js"))
                .contains("new URL(\"./jsm-decoder.wasm\", import.meta.url)")
                .contains("new URL(\"./jsm-decoder.js\", import.meta.url).href")
                .contains("@vite-ignore", "webpackIgnore: true")
                .doesNotContain("import {");
        assertThat(text("jsm-decoder.wasm")).isEqualTo("wasm");
        assertThat(text("jsm-decoder.js")).isEqualTo("export const decoder = 1;\n");
        assertThat(Folders.files(folder.resolve("package")))
                .filteredOn(file -> file.getFileName().toString().startsWith("chunk-"))
                .singleElement()
                .satisfies(
                        chunk -> assertThat(chunk).content().contains("new URL(\"./jsm-worker.js\", import.meta.url)"));
    }

    @Test
    void shouldPackTheFolderAsNpmDoes() throws Exception {
        Files.write(folder.resolve("package/a.bin"), new byte[1024]);
        build();
        Path out = Files.createDirectories(folder.resolve("out"));
        Process tar = new ProcessBuilder(
                        "tar", "-xzf", folder.resolve("package.tgz").toString())
                .directory(out.toFile())
                .redirectErrorStream(true)
                .start();
        assertThat(new String(tar.getInputStream().readAllBytes())).isEmpty();
        assertThat(tar.waitFor()).isZero();
        Path packed = folder.resolve("package");
        assertThat(Folders.files(out.resolve("package")))
                .hasSameSizeAs(Folders.files(packed))
                .allSatisfy(file -> assertThat(file).hasSameBinaryContentAs(packed.resolve(file.getFileName())));
    }

    @Test
    void shouldTellWhichSourceIsMissing() throws IOException {
        Files.delete(folder.resolve("sources/viewer/jsm-viewer.js"));
        assertThatThrownBy(this::build).isInstanceOf(IOException.class).hasMessageContaining("viewer/jsm-viewer.js");
    }
}
