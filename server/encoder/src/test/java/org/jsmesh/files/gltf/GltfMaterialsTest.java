package org.jsmesh.files.gltf;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.Texture;
import org.jsmesh.mesh.io.ModelFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Materials are kept as the JSON that they were, with their textures in it. */
class GltfMaterialsTest {
    private static final byte[] PNG = {(byte) 0x89, 'P', 'N', 'G', 13, 10};
    private static final byte[] WEBP = "RIFF....WEBPVP8 ".getBytes(StandardCharsets.ISO_8859_1);

    private static ModelFile read(String material, String rest, byte[]... images) throws IOException {
        GlbBuilder builder = new GlbBuilder();
        builder.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
        for (byte[] image : images) builder.view(image);
        return builder.primitive("{\"attributes\":{\"POSITION\":0},\"material\":0}")
                .rest(",\"materials\":[" + material + "]" + rest)
                .read();
    }

    private static Material material(ModelFile file) {
        assertThat(file.mesh().materials()).hasSize(1);
        return file.mesh().materials().get(0);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "{}|{}",
                "{ \"name\": \"m\", \"doubleSided\" : true }|{\"doubleSided\":true}",
                "{\"alphaCutoff\":0.50,\"alphaMode\":\"MASK\"}|{\"alphaCutoff\":0.50,\"alphaMode\":\"MASK\"}",
                "{\"pbrMetallicRoughness\":{\"roughnessFactor\":1e-1,\"baseColorFactor\":[1,0.5,-0.0,1.0]}}"
                        + "|{\"pbrMetallicRoughness\":{\"roughnessFactor\":1e-1,\"baseColorFactor\":[1,0.5,-0.0,1.0]}}",
                "{\"extras\":{\"b\":[1,{}],\"a\":null},\"extensions\":{\"KHR_materials_ior\":{\"ior\":1.45},\"X\":[7]}}"
                        + "|{\"extras\":{\"b\":[1,{}],\"a\":null},\"extensions\":{\"KHR_materials_ior\":{\"ior\":1.45},\"X\":[7]}}"
            })
    void shouldKeepTheDefinitionWordForWord(String given, String expected) throws IOException {
        ModelFile file = read(given, "");
        assertThat(material(file).gltf()).isEqualTo(expected);
        assertThat(material(file).name()).isEqualTo(given.contains("\"m\"") ? "m" : "material0");
        assertThat(material(file).parameters()).isEmpty();
        assertThat(file.notes()).isEmpty();
    }

    @Test
    void shouldPutTexturesWithTheirSamplersInThePlaceOfTheirNumbers() throws IOException {
        ModelFile file = read(
                "{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":1,\"texCoord\":1,\"extensions\":"
                        + "{\"KHR_texture_transform\":{\"scale\":[2,2]}}}},\"normalTexture\":{\"scale\":2,\"index\":0}}",
                ",\"textures\":[{\"source\":1},{\"sampler\":0,\"name\":\"t\",\"source\":0}],"
                        + "\"samplers\":[{\"wrapS\":33071,\"name\":\"s\"}],"
                        + "\"images\":[{\"bufferView\":1,\"mimeType\":\"image/jpeg\"},{\"uri\":\"a%20b.png\"}]",
                PNG);
        assertThat(material(file).gltf())
                .isEqualTo(
                        "{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":{\"sampler\":"
                                + "{\"wrapS\":33071,\"name\":\"s\"},\"name\":\"t\",\"source\":1},\"texCoord\":1,\"extensions\":"
                                + "{\"KHR_texture_transform\":{\"scale\":[2,2]}}}},\"normalTexture\":{\"scale\":2,\"index\":{\"source\":0}}}");
        assertThat(material(file).textures())
                .containsExactly(
                        new Material.TextureReference("normalTexture", "a b.png"),
                        new Material.TextureReference("baseColorTexture", "image0.png"));
        assertThat(file.mesh().textures()).extracting(Texture::path).containsExactly("image0.png");
        assertThat(file.mesh().textures().get(0).bytes()).isEqualTo(PNG);
        assertThat(file.notes())
                .containsExactly(Note.dropped(
                                "Textures not found; put the images beside the model under these names and encode it again: a b.png.",
                                1,
                                "a b.png")
                        .asWarning());
    }

    @Test
    void shouldKeepTexturesOfExtensionsAndSourcesInExtensions() throws IOException {
        ModelFile file = read(
                "{\"emissiveTexture\":{\"index\":0},\"extensions\":{\"KHR_materials_clearcoat\":"
                        + "{\"clearcoatTexture\":{\"index\":1}},\"KHR_materials_x\":{\"in\":{\"yTexture\":{\"index\":1}}}},"
                        + "\"extras\":{\"zTexture\":{\"index\":1}}}",
                ",\"textures\":[{\"source\":0,\"extensions\":{\"EXT_texture_webp\":{\"source\":1}}},"
                        + "{\"extensions\":{\"KHR_texture_basisu\":{\"source\":0}}}],"
                        + "\"images\":[{\"bufferView\":1,\"name\":\"one\"},{\"bufferView\":2,\"name\":\"one\"}]",
                PNG,
                WEBP);
        assertThat(material(file).gltf())
                .isEqualTo(
                        "{\"emissiveTexture\":{\"index\":{\"source\":0,\"extensions\":{\"EXT_texture_webp\":{\"source\":1}}}},"
                                + "\"extensions\":{\"KHR_materials_clearcoat\":{\"clearcoatTexture\":{\"index\":"
                                + "{\"extensions\":{\"KHR_texture_basisu\":{\"source\":2}}}}},\"KHR_materials_x\":{\"in\":{\"yTexture\":"
                                + "{\"index\":{\"extensions\":{\"KHR_texture_basisu\":{\"source\":3}}}}}}},"
                                + "\"extras\":{\"zTexture\":{\"index\":1}}}");
        assertThat(material(file).textures())
                .containsExactly(
                        new Material.TextureReference("emissiveTexture", "one.png"),
                        new Material.TextureReference("emissiveTexture.EXT_texture_webp", "one.webp"),
                        new Material.TextureReference(
                                "KHR_materials_clearcoat.clearcoatTexture.KHR_texture_basisu", "one.png"),
                        new Material.TextureReference("KHR_materials_x.yTexture.KHR_texture_basisu", "one.png"));
        assertThat(file.mesh().textures()).extracting(Texture::path).containsExactly("one.png", "one.webp");
        assertThat(file.notes()).isEmpty();
    }

    @Test
    void shouldNameImagesByWhatTheyAreAndEachInItsOwnWay() throws IOException {
        ModelFile file = read(
                "{\"normalTexture\":{\"index\":0},\"emissiveTexture\":{\"index\":1},\"occlusionTexture\":{\"index\":2},"
                        + "\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":3}}}",
                ",\"textures\":[{\"source\":0},{\"source\":1},{\"source\":2},{\"source\":3}],\"images\":["
                        + "{\"bufferView\":1,\"name\":\"wood.JPG\"},{\"bufferView\":2,\"name\":\"wood.JPG\"},"
                        + "{\"uri\":\"wood.JPG.webp\"},{\"bufferView\":3,\"name\":\"skin.jpeg\"}]",
                WEBP,
                WEBP,
                new byte[] {(byte) 0xFF, (byte) 0xD8, 1});
        assertThat(file.mesh().textures())
                .extracting(Texture::path)
                .containsExactly("0-wood.JPG.webp", "1-wood.JPG.webp", "skin.jpeg");
        assertThat(material(file).textures())
                .extracting(Material.TextureReference::path)
                .contains("wood.JPG.webp");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "\"pbrMetallicRoughness\":{\"baseColorFactor\":[1.00000012,0.6,0.1,1]}|\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,0.6,0.1,1]}|false",
                "\"pbrMetallicRoughness\":{\"metallicFactor\":-1e-9}|\"pbrMetallicRoughness\":{\"metallicFactor\":0}|false",
                "\"pbrMetallicRoughness\":{\"roughnessFactor\":1.0000001}|\"pbrMetallicRoughness\":{\"roughnessFactor\":1}|false",
                "\"emissiveFactor\":[0,5,1e999]|\"emissiveFactor\":[0,1,1]|true",
                "\"alphaCutoff\":-1|\"alphaCutoff\":0|true"
            })
    void shouldClampFactorsThatAreOutOfRange(String given, String expected, boolean warning) throws IOException {
        ModelFile file = read("{" + given + "}", "");
        assertThat(material(file).gltf()).isEqualTo("{" + expected + "}");
        assertThat(file.notes())
                .singleElement()
                .matches(note -> note.kind() == Note.Kind.CHANGED
                        && note.warning() == warning
                        && note.text().startsWith("Values of materials out of range clamped: material0: "));
    }

    @Test
    void shouldClampTheStrengthOfOcclusion() throws IOException {
        ModelFile file = read(
                "{\"occlusionTexture\":{\"index\":0,\"strength\":2}}",
                ",\"textures\":[{\"source\":0}],\"images\":[{\"bufferView\":1}]",
                PNG);
        assertThat(material(file).gltf()).isEqualTo("{\"occlusionTexture\":{\"index\":{\"source\":0},\"strength\":1}}");
        assertThat(file.notes()).singleElement().matches(Note::warning);
    }

    @Test
    void shouldWriteAlphaModesInCapitals() throws IOException {
        ModelFile file = read("{\"alphaMode\":\"mask\"}", "");
        assertThat(material(file).gltf()).isEqualTo("{\"alphaMode\":\"MASK\"}");
        assertThat(file.notes())
                .containsExactly(
                        Note.repaired("Alpha modes written in capitals: material0: mask.", 1, "material0: mask"));
    }

    @Test
    void shouldLeaveOutWhatIsOfAnotherKindThanGltfHas() throws IOException {
        ModelFile file = read(
                "{\"alphaMode\":\"SOLID\",\"alphaCutoff\":null,\"doubleSided\":1,\"emissiveFactor\":[1,2],"
                        + "\"pbrMetallicRoughness\":{\"baseColorFactor\":7,\"metallicFactor\":\"x\",\"baseColorTexture\":{\"index\":0}},"
                        + "\"normalTexture\":null}",
                ",\"textures\":[{\"source\":0,\"sampler\":0}],\"samplers\":[{\"wrapS\":5,\"magFilter\":9728}],\"images\":[{\"bufferView\":1}]",
                PNG);
        assertThat(material(file).gltf())
                .isEqualTo(
                        "{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":{\"source\":0,\"sampler\":{\"magFilter\":9728}}}}}");
        assertThat(file.notes())
                .singleElement()
                .matches(note -> note.count() == 8 && note.example().equals("material0: alphaMode"));
    }

    @Test
    void shouldWarnOfTexturesThatAreNotThereOrHaveNoImage() throws IOException {
        ModelFile file = read(
                "{\"normalTexture\":{\"index\":5},\"emissiveTexture\":{\"index\":0},\"occlusionTexture\":{\"index\":1}}",
                ",\"textures\":[{},{\"source\":9}]");
        assertThat(material(file).gltf())
                .isEqualTo("{\"emissiveTexture\":{\"index\":{}},\"occlusionTexture\":{\"index\":{}}}");
        assertThat(file.notes())
                .containsExactly(
                        Note.dropped(
                                        "Textures without an image in a known format: emissiveTexture, occlusionTexture.",
                                        2,
                                        "emissiveTexture")
                                .asWarning(),
                        Note.dropped(
                                        "Textures that the file does not have left out: normalTexture.",
                                        1,
                                        "normalTexture")
                                .asWarning());
    }

    @Test
    void shouldWarnOfMaterialsThatAreNotThere() throws IOException {
        ModelFile file = read("null", "");
        assertThat(file.mesh().materials()).isEmpty();
        assertThat(file.mesh().faceMaterials()).containsExactly(-1);
        assertThat(file.notes())
                .containsExactly(Note.dropped("1 material not in the file: faces without material instead.", 1, "")
                        .asWarning());
    }

    @Test
    void shouldTakeTheDefinitionOfAnotherFormatFromTheExtras() throws IOException {
        ModelFile file = read(
                "{\"name\":\"m\",\"emissiveFactor\":[9,9,9],\"extras\":{\"jsm\":{\"parameters\":[[\"Kd\",0.5,0,1],[\"illum 2\"]],"
                        + "\"textures\":[[\"map_Kd\",\"dir/a.png\"]]}}}",
                ",\"images\":[{\"name\":\"x\"},{\"name\":\"dir/a.png\",\"bufferView\":1}]",
                PNG);
        assertThat(material(file))
                .isEqualTo(new Material(
                        "m",
                        List.of(new Material.Parameter("Kd", .5f, 0, 1), new Material.Parameter("illum 2")),
                        List.of(new Material.TextureReference("map_Kd", "dir/a.png"))));
        assertThat(file.mesh().textures()).extracting(Texture::path).containsExactly("dir/a.png");
        assertThat(file.notes()).isEmpty();
    }

    @Test
    void shouldRefuseADefinitionThatGrowsBeyondAllMeasure() {
        String large = "\"" + "x".repeat(100_000) + "\"";
        StringBuilder slots = new StringBuilder("{\"extensions\":{\"A\":{");
        for (int i = 0; i < 200; i++) slots.append("\"t" + i + "Texture\":{\"index\":0},");
        org.assertj.core.api.Assertions.assertThatThrownBy(
                        () -> read(slots + "\"end\":0}}}", ",\"textures\":[{\"extras\":" + large + "}]"))
                .hasMessageContaining("unpacks to more than");
    }
}
