package org.jsmesh.web.build;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PageBuildTest {
    @TempDir
    private Path folder;

    @BeforeEach
    void writeSources() throws IOException {
        write("page/index.html", """
                <html>
                  <head>
                    <link rel="stylesheet" href="look.css">
                  </head>
                  <body>
                  <a href="./">all</a><a href="nowhere.txt">none</a>
                    <script type="module" src="app.js"></script>
                  </body>
                </html>
                """);
        write("page/look.css", "body { color: #ff0000; }\n");
        write("page/app.js", """
                import { shared } from './shared.js';
                import { Vector2 } from 'three';
                new Worker(new URL('../decode/worker.js', import.meta.url));
                console.log(shared, new Vector2(1, 2));
                import('./later.js');
                """);
        write("page/shared.js", "export const shared = ['shared'];\n");
        write("page/later.js", """
                import * as THREE from 'three';
                import { shared } from './shared.js';
                console.log(shared, new THREE.Matrix4());
                """);
        write("decode/worker.js", """
                fetch(new URL('../decoder/decoder.wasm', import.meta.url));
                import('../decoder/decoder.js');
                """);
        write("../decoder/decoder.wasm", "one");
        write("../decoder/decoder.js", "export const decoder = 1;\n");
    }

    private void write(String name, String text) throws IOException {
        Path file = folder.resolve("sources").resolve(name).normalize();
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
    }

    private Path build(String name) throws IOException {
        Path output = folder.resolve(name);
        PageBuild.main(new String[] {
            folder.resolve("sources").toString(),
            folder.resolve("decoder").toString(),
            folder.resolve("work-" + name).toString(),
            output.toString()
        });
        return output;
    }

    private static SortedMap<String, String> read(Path output) throws IOException {
        SortedMap<String, String> files = new TreeMap<>();
        for (Path file : Folders.files(output)) {
            files.put(
                    Folders.relative(output, file),
                    new String(Files.readAllBytes(file), java.nio.charset.StandardCharsets.ISO_8859_1));
        }
        return files;
    }

    private static String one(Map<String, String> files, String pattern) {
        return files.keySet().stream()
                .filter(name -> name.matches("viewer/" + pattern))
                .reduce((a, b) -> {
                    throw new AssertionError("both " + a + " and " + b);
                })
                .orElseThrow(() -> new AssertionError("no " + pattern + " among " + files.keySet()));
    }

    private static String file(String name) {
        return name.substring("viewer/".length());
    }

    @Test
    void shouldPutTheNamesOfServedFilesInPlaceOfSources() throws IOException {
        Map<String, String> files = read(build("page"));
        String app = one(files, "app-[A-Z2-7]{8}\\.js");
        String worker = one(files, "worker-[A-Z2-7]{8}\\.js");
        String later = one(files, "later-[A-Z2-7]{8}\\.js");
        String wasm = one(files, "decoder-[A-Z2-7]{8}\\.wasm");
        assertThat(files.get("index.html"))
                .contains("href=\"" + one(files, "look-[A-Z2-7]{8}\\.css") + "\"", "src=\"" + app + "\"")
                .contains("<a href=\"./\">", "<a href=\"nowhere.txt\">");
        assertThat(files.get(app)).contains("\"./" + file(worker) + "\"", "import(\"./" + file(later) + "\")");
        assertThat(files.get(worker))
                .contains("\"./" + file(wasm) + "\"", "import(\"./" + file(one(files, "decoder-.*\\.js")) + "\")");
        assertThat(files.get(wasm)).isEqualTo("one");
    }

    @Test
    void shouldHintAtWhatTheScriptImportsAtOnce() throws IOException {
        Map<String, String> files = read(build("page"));
        String chunk = one(files, "chunk-[A-Z2-7]{8}\\.js");
        assertThat(files.get(chunk)).contains("shared");
        assertThat(files.get("index.html"))
                .containsOnlyOnce("modulepreload")
                .contains("<link rel=\"modulepreload\" href=\"" + chunk + "\">\n");
    }

    @Test
    void shouldGiveEachFileOnlyWhatItNeedsOfThree() throws IOException {
        Map<String, String> files = read(build("page"));
        String app = files.get(one(files, "app-.*\\.js"));
        String later = files.get(one(files, "later-.*\\.js"));
        assertThat(app).contains("isVector2").doesNotContain("makeRotationFromEuler", "WebGL");
        assertThat(later).contains("makeRotationFromEuler").doesNotContain("WebGL");
    }

    @Test
    void shouldGiveTheSameBytesInAnotherFolder() throws IOException {
        assertThat(read(build("page"))).isEqualTo(read(build("other")));
    }

    @Test
    void shouldGiveAllThatDependsOnAChangedFileAnotherName() throws IOException {
        Map<String, String> before = read(build("page"));
        write("../decoder/decoder.wasm", "two");
        Map<String, String> after = read(build("page"));
        for (String name : new String[] {"decoder-.*\\.wasm", "worker-.*\\.js", "app-.*\\.js"}) {
            assertThat(one(after, name)).as(name).isNotEqualTo(one(before, name));
        }
        assertThat(one(after, "look-.*\\.css")).isEqualTo(one(before, "look-.*\\.css"));
    }

    @Test
    void shouldLeaveEverythingAloneWhenNothingHasChanged() throws IOException {
        Path output = build("page");
        Path index = output.resolve("index.html");
        Files.writeString(index, "touched");
        build("page");
        assertThat(index).hasContent("touched");
        write("page/look.css", "body { color: #00ff00; }\n");
        build("page");
        assertThat(index).content().contains("look-");
    }

    @Test
    void shouldBuildWithoutADecoder() throws IOException {
        Folders.clear(folder.resolve("decoder"));
        Map<String, String> files = read(build("page"));
        assertThat(files.get(one(files, "decoder-.*\\.js"))).contains("without a decoder");
    }

    @Test
    void shouldTellWhatIsWrongWithASource() throws IOException {
        write("page/app.js", "import './missing.js';\n");
        assertThatThrownBy(() -> build("page")).isInstanceOf(IOException.class).hasMessageContaining("missing.js");
        write("page/app.js", "");
        assertThat(build("page").resolve("index.html")).exists();
    }
}
