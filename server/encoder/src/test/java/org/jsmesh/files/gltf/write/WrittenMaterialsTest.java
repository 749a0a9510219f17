package org.jsmesh.files.gltf.write;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.BitSet;
import java.util.List;
import java.util.stream.IntStream;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Material.TextureReference;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshComparison;
import org.jsmesh.mesh.Texture;
import org.junit.jupiter.api.Test;

/** Materials of glTF come back word for word; others look the same, and come back too. */
class WrittenMaterialsTest {
    private static final byte[] PNG = bytes("\u0089PNG picture");
    private static final byte[] JPEG = bytes("\u00ff\u00d8 picture");
    private static final byte[] WEBP = bytes("RIFF....WEBP picture");
    private static final byte[] KTX2 = bytes("\u00abKTX 20\u00bb picture");

    private static final TextureReference NORMAL = use("normalTexture", "a.png");

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.ISO_8859_1);
    }

    /** A face for each material, with texture coordinates on all but the last. */
    private static Mesh mesh(List<Material> materials, Texture... textures) {
        int faces = materials.size() + 1;
        float[] positions = new float[9 * faces];
        for (int i = 0; i < positions.length; i++) positions[i] = i * i % 17;
        BitSet last = new BitSet();
        last.set(3 * faces - 3, 3 * faces);
        return new MeshBuilder()
                .positions(positions)
                .faceWedges(IntStream.range(0, 3 * faces).toArray())
                .faceMaterials(IntStream.range(0, faces)
                        .map(f -> Math.min(f, materials.size() - 1))
                        .toArray())
                .channels(List.of(new Channel(
                        Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, new int[6 * faces], last)))
                .materials(materials)
                .textures(List.of(textures))
                .build();
    }

    private static Material gltf(String name, String json, TextureReference... textures) {
        return new Material(name, List.of(), List.of(textures), json);
    }

    private static TextureReference use(String key, String path) {
        return new TextureReference(key, path);
    }

    @Test
    void shouldWriteMaterialsOfGltfWordForWord() throws IOException {
        String first = "{\"emissiveFactor\":[1.0,0.50,2E-1],\"pbrMetallicRoughness\":{\"baseColorTexture\":"
                + "{\"texCoord\":1,\"index\":{\"sampler\":{\"wrapS\":33071,\"extras\":{\"a\":1}},\"source\":0,"
                + "\"extensions\":{\"EXT_texture_webp\":{\"source\":1}}},"
                + "\"extensions\":{\"KHR_texture_transform\":{\"offset\":[0,0.10]}}}},"
                + "\"extras\":{\"index\":{\"source\":9},\"extensions\":{\"NOT_used\":{}}}}";
        String second = "{\"extensions\":{\"KHR_materials_clearcoat\":{\"clearcoatTexture\":{\"index\":"
                + "{\"sampler\":{\"wrapS\":33071,\"extras\":{\"a\":1}},\"extensions\":{\"KHR_texture_basisu\":"
                + "{\"source\":1}}}},\"clearcoatFactor\":1}},\"normalTexture\":{\"scale\":-0.0,\"index\":{\"sampler\":{},"
                + "\"source\":0}},\"unknown\":null}";
        List<Material> materials = List.of(
                gltf(
                        "one",
                        first,
                        use("baseColorTexture", "a.png"),
                        use("baseColorTexture.EXT_texture_webp", "a.webp")),
                gltf("", "{}"),
                gltf(
                        "one",
                        second,
                        use("normalTexture", "a.png"),
                        use("KHR_materials_clearcoat.clearcoatTexture.KHR_texture_basisu", "sub folder/c.ktx2")));
        Mesh mesh = mesh(
                materials,
                new Texture("a.png", PNG),
                new Texture("a.webp", WEBP),
                new Texture("sub folder/c.ktx2", KTX2));
        GlbFile file = GlbFile.of(GlbFile.decoded(mesh));
        Mesh read = file.read();
        assertThat(read.materials()).containsExactlyInAnyOrderElementsOf(materials);
        assertThat(MeshComparison.firstDifference(mesh, read)).isEmpty();
        JsonNode json = file.json();
        assertThat(json.path("extensionsUsed"))
                .hasToString("[\"EXT_texture_webp\",\"KHR_materials_clearcoat\",\"KHR_texture_basisu\","
                        + "\"KHR_texture_transform\"]");
        assertThat(json.path("extensionsRequired")).hasToString("[\"KHR_texture_basisu\"]");
        assertThat(json.path("samplers")).hasSize(2);
        assertThat(json.path("textures")).hasSize(3);
        assertThat(json.path("images").findValuesAsText("mimeType"))
                .containsExactlyInAnyOrder("image/png", "image/webp", "image/ktx2");
        assertThat(json.path("images").findValue("extras")).isNull();
    }

    @Test
    void shouldKeepTheOrderOfKeysOfTexturesAndSamplers() throws IOException {
        String start = "{\"normalTexture\":{\"index\":";
        List<Material> materials = List.of(
                gltf("a", start + "{\"source\":0,\"sampler\":{\"wrapS\":33071,\"wrapT\":33071}}}}", NORMAL),
                gltf("b", start + "{\"source\":0,\"sampler\":{\"wrapT\":33071,\"wrapS\":33071}}}}", NORMAL),
                gltf("c", start + "{\"source\":0,\"name\":\"t\"}}}", NORMAL),
                gltf("d", start + "{\"name\":\"t\",\"source\":0}}}", NORMAL),
                gltf("e", start + "{\"name\":\"t\",\"source\":0}}}", NORMAL));
        GlbFile file = GlbFile.of(mesh(materials, new Texture("a.png", PNG)));
        assertThat(file.read().materials()).containsExactlyElementsOf(materials);
        assertThat(file.json().path("samplers")).hasSize(2);
        assertThat(file.json().path("textures")).hasSize(4);
    }

    /** What is no texture info of a definition is written as it is, though its index is an object. */
    @Test
    void shouldTakeNothingElseForATexture() throws IOException {
        List<Material> materials = List.of(
                gltf("a", "{\"extensions\":{\"FOO_bar\":{\"thing\":{\"index\":{\"a\":1}},\"index\":{\"source\":0}}}}"),
                gltf("b", "{\"extras\":{\"normalTexture\":{\"index\":{\"source\":0}}}}"),
                gltf(
                        "c",
                        "{\"extensions\":{\"FOO_bar\":{\"layers\":[{\"texture\":{\"index\":{\"source\":0,"
                                + "\"extensions\":{\"FOO_other\":{\"source\":7}}}}}]}}}",
                        use("FOO_bar.texture", "a.png")));
        GlbFile file = GlbFile.of(mesh(materials, new Texture("a.png", PNG)));
        assertThat(file.json().path("textures"))
                .hasToString("[{\"source\":0,\"extensions\":{\"FOO_other\":{\"source\":7}}}]");
        assertThat(file.read().materials()).containsExactlyElementsOf(materials);
    }

    @Test
    void shouldWriteEqualImagesOnceUnderAllTheirPaths() throws IOException {
        Material material = new Material(
                "m",
                List.of(),
                List.of(use("map_Kd", "a.png"), use("map_Ks", "b.png"), use("norm", "photo.png"), use("x", "y")));
        Mesh mesh = mesh(
                List.of(material),
                new Texture("a.png", PNG),
                new Texture("b.png", PNG.clone()),
                new Texture("photo.png", JPEG),
                new Texture("y", bytes("no picture")));
        GlbFile file = GlbFile.of(mesh);
        JsonNode images = file.json().path("images");
        assertThat(images.findValuesAsText("name")).containsExactly("a.png", "b.png", "photo.png", "y");
        assertThat(images.findValuesAsText("bufferView").stream().distinct()).hasSize(3);
        assertThat(images.findValuesAsText("mimeType"))
                .containsExactly("image/png", "image/png", "image/jpeg", "image/png");
        assertThat(file.remarks())
                .contains("glTF shows only PNG, JPEG, WebP and KTX2 images; others are in the file, but most programs"
                        + " do not show them.");
        Mesh read = file.read();
        assertThat(read.materials()).containsExactly(material);
        assertThat(read.textures().stream().map(Texture::path)).containsExactly("a.png", "b.png", "photo.png", "y");
        for (int t = 0; t < 4; t++)
            assertThat(read.textures().get(t).bytes())
                    .isEqualTo(mesh.textures().get(t).bytes());
    }

    @Test
    void shouldKeepThePathOfAnImageThatIsNamedForAnotherFormat() throws IOException {
        Material material = gltf(
                "m",
                "{\"normalTexture\":{\"index\":{\"source\":0}},\"occlusionTexture\":{\"index\":{\"source\":1}}}",
                use("normalTexture", "photo.png"),
                use("occlusionTexture", "gone/ä+b.png"));
        GlbFile file = GlbFile.of(mesh(List.of(material), new Texture("photo.png", JPEG)));
        assertThat(file.json().path("images").get(0).path("extras")).hasToString("{\"jsm\":{\"path\":\"photo.png\"}}");
        assertThat(file.json().path("images").get(1)).hasToString("{\"uri\":\"gone/%C3%A4%2Bb.png\"}");
        assertThat(file.read().materials()).containsExactly(material);
    }

    @Test
    void shouldShowAMaterialWithoutItsImageWhereThereAreNoCoordinates() throws IOException {
        Material material = new Material(
                "wood",
                List.of(new Material.Parameter("Kd", 1, 0, 0)),
                List.of(use("map_Kd", "a.webp"), use("map_Ke", "b.png"), use("map_Pm", "c.png")));
        Mesh mesh = mesh(List.of(material), new Texture("a.webp", WEBP), new Texture("b.png", PNG));
        GlbFile file = GlbFile.of(mesh);
        JsonNode textured = file.json().path("materials").get(0);
        JsonNode twin = file.json().path("materials").get(1);
        JsonNode pbr = textured.path("pbrMetallicRoughness");
        assertThat(pbr.path("baseColorFactor")).hasToString("[1,1,1,1]");
        assertThat(pbr.path("metallicFactor")).hasToString("0");
        assertThat(pbr.path("baseColorTexture").path("extensions"))
                .hasToString("{\"KHR_texture_transform\":{\"offset\":[0,1],\"scale\":[1,-1]}}");
        assertThat(textured.path("emissiveTexture").path("index").intValue()).isEqualTo(1);
        assertThat(textured.path("emissiveFactor")).hasToString("[1,1,1]");
        assertThat(twin.path("pbrMetallicRoughness").path("baseColorFactor")).hasToString("[1,0,0,1]");
        assertThat(twin.findValue("index")).isNull();
        assertThat(twin.has("emissiveFactor")).isFalse();
        assertThat(twin.path("extras")).hasToString("{\"jsm\":{\"sameAs\":0}}");
        assertThat(file.json().path("extensionsRequired")).hasToString("[\"EXT_texture_webp\"]");
        assertThat(file.remarks())
                .contains("glTF has no such images by themselves, so the extras alone have them: map_Pm.");
        assertThat(file.read().materials()).containsExactly(material);
    }

    @Test
    void shouldSayWhichDefinitionIsNoJson() throws IOException {
        GlbFile file = GlbFile.of(mesh(List.of(gltf("odd", "{\"a\":"), gltf("flat", "[]"))));
        assertThat(file.notes()).containsExactly("Definitions of materials that are no JSON left out: odd, flat.");
        assertThat(file.json().path("materials")).hasToString("[{\"name\":\"odd\"},{\"name\":\"flat\"}]");
    }

    @Test
    void shouldWriteTheSameBytesAgain() throws IOException {
        Mesh mesh = mesh(
                List.of(gltf("m", "{\"normalTexture\":{\"index\":{\"source\":0}}}", use("normalTexture", "a.png"))),
                new Texture("a.png", PNG));
        assertThat(GlbFile.of(mesh).bytes()).isEqualTo(GlbFile.of(mesh).bytes());
    }
}
