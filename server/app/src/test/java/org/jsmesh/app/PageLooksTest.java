package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.jsmesh.app.server.JsmServer;
import org.jsmesh.app.server.ServerSettings;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.sandbox.ModelFilesEncoder;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;
import org.jsmesh.test.material.ExtensionModels;
import org.jsmesh.test.material.MaterialModel;
import org.jsmesh.test.material.MaterialModels;
import org.jsmesh.test.material.MtlModels;
import org.jsmesh.test.picture.PictureComparison;
import org.jsmesh.test.picture.View;
import org.jsmesh.web.testing.Browser;
import org.jsmesh.web.testing.ReferencePage;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Each property of a material as the page draws it, beside three's own loader on the original file: over the pixels
 * that either draws, before black and before white, the mean difference is below {@value #TOLERANCE} of white. A twin
 * of the model that lacks the property differs by more than {@value #VISIBLE} of white, so that a page without the
 * property would fail.
 */
@Tag("long")
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
@Timeout(300)
class PageLooksTest {
    private static final double TOLERANCE = .02;
    private static final double VISIBLE = .04;
    private static final int SIDE = 200;
    /** Each page costs seconds: every twentieth model, and all with {@code -Djsm.test.looks=all}. */
    private static final int STEP = "all".equals(System.getProperty("jsm.test.looks")) ? 1 : 20;

    @TempDir
    static Path folder;

    private Browser browser;
    private Browser other;
    private ReferencePage reference;
    private ModelStore store;
    private JsmServer server;

    @BeforeAll
    void start() throws Exception {
        Path models = Files.createDirectory(folder.resolve("models"));
        for (MaterialModel model : all()) model.write(models);
        StoreSettings settings = StoreSettings.of(models).withCache(folder.resolve("cache"));
        store = new ModelStore(settings, new ModelFilesEncoder(EncoderSettings.defaults()));
        server = JsmServer.start(ServerSettings.defaults(), store);
        browser = new Browser(Files.createDirectory(folder.resolve("profile")));
        other = new Browser(Files.createDirectory(folder.resolve("other-profile")));
        reference = new ReferencePage(other);
    }

    @AfterAll
    void stop() throws IOException {
        if (reference != null) reference.close();
        if (other != null) other.close();
        if (browser != null) browser.close();
        if (server != null) server.close();
        if (store != null) store.close();
    }

    static Stream<MaterialModel> models() {
        List<MaterialModel> all = all();
        return Stream.iterate(0, i -> i < all.size(), i -> i + STEP).map(all::get);
    }

    private static List<MaterialModel> all() {
        return Stream.of(MaterialModels.all(), ExtensionModels.all(), MtlModels.all())
                .flatMap(List::stream)
                .toList();
    }

    @ParameterizedTest
    @MethodSource("models")
    void shouldDrawEachPropertyAsThreeDoes(MaterialModel model) throws IOException {
        show(model.name(), "smooth");
        View view = view();
        BufferedImage drawn = browser.snapshot(SIDE, SIDE);
        BufferedImage expected = reference.draw(model.reference(), view, SIDE, SIDE);
        BufferedImage without = reference.draw(model.without(), view, SIDE, SIDE);
        PagePictures.keep("look-" + model.name(), PagePictures.beside(drawn, expected, without));
        assertThat(PictureComparison.visibleDifference(expected, without))
                .as("what the property changes")
                .isGreaterThan(VISIBLE);
        assertThat(PictureComparison.visibleDifference(drawn, expected))
                .as("difference from three's own loader")
                .isLessThan(TOLERANCE);
        assertThat(browser.consoleErrors()).isEmpty();
    }

    @Test
    void shouldShadeMaterialsOfGltfInEveryWay() throws IOException {
        show("base-colour-texture", "smooth");
        List<BufferedImage> pictures = new ArrayList<>();
        for (String shading : List.of("smooth", "flat", "matte", "normals")) {
            browser.call("jsm.setShading(args[0]);", shading);
            pictures.add(browser.snapshot(SIDE, SIDE));
        }
        PagePictures.keep("look-shadings", PagePictures.beside(pictures.toArray(BufferedImage[]::new)));
        for (int i = 0; i < pictures.size(); i++)
            for (int k = 0; k < i; k++)
                assertThat(PictureComparison.visibleDifference(pictures.get(i), pictures.get(k)))
                        .as("shadings " + i + " and " + k)
                        .isBetween(.005, .5);
        browser.call("document.getElementById('wireframe').click();");
        BufferedImage wires = browser.snapshot(SIDE, SIDE);
        assertThat(PictureComparison.opaque(wires).cardinality())
                .isBetween(100, PictureComparison.opaque(pictures.get(0)).cardinality() - 100);
        assertThat(browser.consoleErrors()).isEmpty();
    }

    /** A definition comes from the archive, which anybody may have written. */
    @Test
    void shouldDrawDefinitionsThatAreNoMaterials() {
        show("unlit", "smooth");
        List<String> definitions = List.of(
                "nonsense",
                "[]",
                "null",
                "7",
                "{\"extensions\":null,\"pbrMetallicRoughness\":null}",
                "{\"pbrMetallicRoughness\":{\"baseColorFactor\":null}}",
                "{\"pbrMetallicRoughness\":{\"baseColorFactor\":3,\"metallicFactor\":\"x\"},\"emissiveFactor\":{}}",
                "{\"normalTexture\":{\"index\":{}},\"occlusionTexture\":{\"index\":{\"source\":9}}}",
                "{\"extensions\":{\"KHR_materials_pbrSpecularGlossiness\":{\"diffuseFactor\":1,"
                        + "\"specularGlossinessTexture\":2}}}");
        assertThat(browser.call(
                        "const { Materials } = await import(new URL('modules/three/materials.js', document.baseURI).href);"
                                + "const materials = new Materials(1, () => {});"
                                + "const slots = args[0].map((gltf) => ({ gltf, images: [] }));"
                                + "await materials.open({ slots, channels: [] });"
                                + "return materials.all.filter((m) => m.isMaterial).length;",
                        definitions))
                .isEqualTo((long) definitions.size());
    }

    private void show(String model, String shading) {
        browser.open(server.uri().resolve("?shading=" + shading + "&m=" + model));
        browser.await("window.jsm?.state === 'idle' || window.jsm?.state === 'complete'");
        browser.call("await jsm.complete();");
        browser.await("jsm.texturesLoading === 0");
    }

    private View view() {
        Map<?, ?> camera = (Map<?, ?>) browser.call("return jsm.camera;");
        return new View(
                vector(camera, "eye"),
                vector(camera, "target"),
                vector(camera, "up"),
                ((Number) camera.get("fieldOfView")).doubleValue());
    }

    private static double[] vector(Map<?, ?> camera, String name) {
        return ((List<?>) camera.get(name))
                .stream().mapToDouble(v -> ((Number) v).doubleValue()).toArray();
    }

    @Test
    void shouldLoadTheLoaderOfGltfWithModelsOfGltfAlone() throws IOException {
        String loaders =
                "return performance.getEntriesByType('resource').filter(r => r.name.includes('/gltf-materials')).length;";
        show("unlit", "smooth");
        assertThat(browser.call(loaders)).isEqualTo(1L);
        Files.writeString(folder.resolve("models/plain.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        show("plain", "smooth");
        assertThat(browser.call(loaders)).isEqualTo(0L);
    }
}
