package org.jsmesh.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.jsmesh.web.testing.Browser;
import org.jsmesh.web.testing.PageServer;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;

/** Pages of others that use the npm package, without a bundler. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class NpmPackageTest {
    private static final Path PACKAGE = Path.of(System.getProperty("jsm.npm.package"));
    private static final String POLICY =
            "default-src 'self' blob: data:; script-src 'self' 'unsafe-inline' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'";
    private static final String THREE = """
            <!doctype html>
            <link rel=icon href=data:,>
            <script type="importmap">
            {"imports": {"three": "/modules/vendor/three.module.min.js",
             "three/addons/environments/RoomEnvironment.js": "/modules/vendor/RoomEnvironment.js",
             "three/addons/loaders/GLTFLoader.js": "/modules/vendor/GLTFLoader.js"}}
            </script>
            """;
    private static final String LOADER = THREE + """
            <script type="module">
              import * as THREE from 'three';
              import { JsmLoader } from '/node_modules/jsm-viewer/jsm-loader.js';

              const renderer = new THREE.WebGLRenderer({ preserveDrawingBuffer: true });
              document.body.append(renderer.domElement);
              const scene = new THREE.Scene();
              scene.add(new THREE.HemisphereLight(0xffffff, 0x888888, 3));
              const model = await new JsmLoader().loadAsync('/model.jsm');
              scene.add(model);
              const { center, radius } = model.bounds.getBoundingSphere(new THREE.Sphere());
              const camera = new THREE.PerspectiveCamera(40, 2, radius / 10, radius * 10);
              camera.position.set(0, radius, 3 * radius).add(center);
              camera.lookAt(center);
              const proofs = [];
              model.addEventListener('identical', ({ meshSha256 }) => proofs.push(meshSha256));
              await model.complete();
              renderer.render(scene, camera);
              Object.assign(window, { model, proofs, picture: renderer.domElement.toDataURL() });
            </script>
            """;
    private static final String ELEMENT = THREE + """
            <script type="module" src="/node_modules/jsm-viewer/jsm-viewer.js"></script>
            <jsm-viewer src="/model.jsm" alt="A shape" camera-controls style="display: block; height: 300px"></jsm-viewer>
            """;

    @TempDir
    static Path profile;

    private PageServer server;
    private Browser browser;

    @BeforeAll
    void start() throws IOException {
        browser = new Browser(profile);
        server = new PageServer(POLICY);
        try (Stream<Path> files = Files.list(PACKAGE)) {
            for (Path file : files.toList()) {
                server.put("/node_modules/jsm-viewer/" + file.getFileName(), Files.readAllBytes(file));
            }
        }
        server.put("/model.jsm", DecodingSessionTest.archive("image.png"));
        server.put("/loader.html", LOADER.getBytes(StandardCharsets.UTF_8));
        server.put("/element.html", ELEMENT.getBytes(StandardCharsets.UTF_8));
    }

    @AfterAll
    void stop() {
        if (browser != null) browser.close();
        if (server != null) server.close();
    }

    @Test
    void shouldLoadAModelIntoASceneOfThree() {
        browser.open(server.address("/loader.html"));
        browser.await("window.picture !== undefined");
        assertThat(browser.call("return model.figures.error;")).isNull();
        assertThat((List<?>) browser.call("return proofs;")).hasSize(1);
        assertThat(browser.call("return model.figures.faces === model.figures.totalFaces && model.figures.faces > 0;"))
                .isEqualTo(true);
        Object colours = browser.call("""
                const image = new Image();
                image.src = picture;
                await image.decode();
                const canvas = new OffscreenCanvas(image.width, image.height).getContext('2d');
                canvas.drawImage(image, 0, 0);
                const { data } = canvas.getImageData(0, 0, image.width, image.height);
                return new Set(new Uint32Array(data.buffer)).size;
                """);
        assertThat(((Number) colours).intValue()).isGreaterThan(1);
        assertThat(browser.consoleErrors()).isEmpty();
    }

    @Test
    void shouldShowAModelByAnElementOfAPage() {
        browser.open(server.address("/element.html"));
        browser.await("document.querySelector('jsm-viewer')?.loaded");
        browser.call("await document.querySelector('jsm-viewer').complete();");
        assertThat(browser.call("return document.querySelector('jsm-viewer').session.figures.proved;"))
                .isEqualTo(true);
        assertThat(browser.consoleErrors()).isEmpty();
    }

    @Test
    void shouldCarryItsLicenceAndWhatItSaysOfItself() throws IOException {
        assertThat(PACKAGE.resolve("LICENSE")).content().contains("Apache License");
        assertThat(PACKAGE.resolve("package.json"))
                .content()
                .contains("\"name\": \"jsm-viewer\"")
                .doesNotContain("${");
        assertThat(PACKAGE.resolve("README.md")).exists();
        for (String module : List.of("jsm-loader", "jsm-viewer")) {
            assertThat(PACKAGE.resolve(module + ".d.ts")).exists();
        }
    }
}
