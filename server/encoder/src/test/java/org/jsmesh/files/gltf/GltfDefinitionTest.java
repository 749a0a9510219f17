package org.jsmesh.files.gltf;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.Texture;
import org.jsmesh.mesh.io.ModelFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Which objects of a material are textures, and what of a material does not fit. */
class GltfDefinitionTest {
    private static final String IMAGE = ",\"images\":[{\"name\":\"i\",\"bufferView\":1}]";

    private static ModelFile read(String material, String rest) throws IOException {
        GlbBuilder builder = new GlbBuilder();
        builder.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
        builder.view(new byte[] {1});
        return builder.primitive("{\"attributes\":{\"POSITION\":0},\"material\":0}")
                .rest(",\"materials\":[" + material + "]" + rest)
                .read();
    }

    private static Material material(ModelFile file) {
        return file.mesh().materials().get(0);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "{\"specialTexture\":{\"index\":0}}|{\"specialTexture\":{\"index\":{\"source\":0}}}|specialTexture",
                "{\"pbrMetallicRoughness\":{\"extensions\":{\"X\":{\"aTexture\":{\"index\":0}}}}}"
                        + "|{\"pbrMetallicRoughness\":{\"extensions\":{\"X\":{\"aTexture\":{\"index\":{\"source\":0}}}}}}|X.aTexture",
                "{\"extensions\":{\"X\":{\"in\":[{\"texture\":{\"index\":0.0}}]}}}"
                        + "|{\"extensions\":{\"X\":{\"in\":[{\"texture\":{\"index\":{\"source\":0}}}]}}}|X.texture"
            })
    void shouldTakeAnObjectUnderATextureKeyForATexture(String given, String expected, String slot) throws IOException {
        ModelFile file = read(given, ",\"textures\":[{\"source\":0}]" + IMAGE);
        assertThat(material(file).gltf()).isEqualTo(expected);
        assertThat(material(file).textures()).containsExactly(new Material.TextureReference(slot, "i.png"));
        assertThat(file.mesh().textures()).extracting(Texture::path).containsExactly("i.png");
        assertThat(file.notes()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "{\"extensions\":{\"X\":{\"map\":{\"index\":0}}}}",
                "{\"extensions\":{\"X\":{\"map\":{\"index\":{\"a\":1}}}}}",
                "{\"extensions\":{\"X\":{\"aTexture\":{\"index\":0.5}}}}",
                "{\"extensions\":{\"X\":{\"aTexture\":7,\"bTexture\":{\"index\":\"0\"},\"texture\":[{\"index\":0}]}}}",
                "{\"extensions\":{\"X\":{\"extras\":{\"aTexture\":{\"index\":0}}}},\"extras\":{\"texture\":{\"index\":{}}}}"
            })
    void shouldTakeNothingElseForATexture(String given) throws IOException {
        ModelFile file = read(given, ",\"textures\":[{\"source\":0}]" + IMAGE);
        assertThat(material(file).gltf()).isEqualTo(given);
        assertThat(material(file).textures()).isEmpty();
        assertThat(file.notes()).isEmpty();
    }

    @Test
    void shouldDropAnObjectThatWouldPassForATextureOfADefinition() throws IOException {
        ModelFile file = read("{\"aTexture\":{\"index\":{\"source\":0}}}", "");
        assertThat(material(file).gltf()).isEqualTo("{}");
        assertThat(file.notes()).singleElement().matches(note -> note.example().equals("aTexture"));
    }

    @Test
    void shouldKeepTheSourceOfAnExtensionThatHasNoImage() throws IOException {
        String texture = "{\"source\":0,\"extensions\":{\"FOO\":{\"source\":{\"x\":1}},\"BAR\":{\"source\":9}}}";
        ModelFile file = read("{\"normalTexture\":{\"index\":0}}", ",\"textures\":[" + texture + "]" + IMAGE);
        assertThat(material(file).gltf()).isEqualTo("{\"normalTexture\":{\"index\":" + texture + "}}");
        assertThat(file.notes()).isEmpty();
    }

    @Test
    void shouldTellOfASourceThatIsNoImage() throws IOException {
        String texture = "{\"source\":0,\"extensions\":{\"EXT_texture_webp\":{\"source\":9}}}";
        ModelFile file = read("{\"normalTexture\":{\"index\":0}}", ",\"textures\":[" + texture + "]" + IMAGE);
        assertThat(material(file).gltf())
                .isEqualTo("{\"normalTexture\":{\"index\":{\"source\":0,\"extensions\":{\"EXT_texture_webp\":{}}}}}");
        assertThat(file.notes())
                .singleElement()
                .matches(note -> note.example().equals("normalTexture.EXT_texture_webp.source"));
    }

    @Test
    void shouldDropExtrasThatAreTooDeep() throws IOException {
        String fits = "[".repeat(63) + "]".repeat(63);
        assertThat(material(read("{\"extras\":" + fits + "}", "")).gltf()).isEqualTo("{\"extras\":" + fits + "}");
        ModelFile file = read("{\"alphaMode\":\"BLEND\",\"extras\":[" + fits + "]}", "");
        assertThat(material(file).gltf()).isEqualTo("{\"alphaMode\":\"BLEND\"}");
        assertThat(file.notes())
                .containsExactly(Note.dropped(
                        "Parts of materials that are larger or deeper than an archive holds dropped: material0: extras.",
                        1,
                        "material0: extras"));
    }

    @Test
    void shouldDropAnExtensionThatIsTooDeep() throws IOException {
        String deep = "[".repeat(63) + "]".repeat(63);
        ModelFile file = read("{\"extensions\":{\"A\":" + deep + ",\"B\":[]}}", "");
        assertThat(material(file).gltf()).isEqualTo("{\"extensions\":{\"B\":[]}}");
        assertThat(file.notes()).singleElement().matches(note -> note.example().equals("material0: A"));
    }

    @Test
    void shouldDropExtrasThatAreTooLong() throws IOException {
        ModelFile file = read("{\"alphaMode\":\"BLEND\",\"extras\":\"" + "y".repeat(1 << 20) + "\"}", "");
        assertThat(material(file).gltf()).isEqualTo("{\"alphaMode\":\"BLEND\"}");
        assertThat(file.notes()).hasSize(1);
    }

    @Test
    void shouldDropPartsOfAnOriginalThatAnArchiveDoesNotHold() throws IOException {
        String textures =
                IntStream.range(0, 4100).mapToObj(i -> "[\"k" + i + "\",\"p\"]").collect(Collectors.joining(","));
        ModelFile file = read(
                "{\"extras\":{\"jsm\":{\"parameters\":[[\"Kd\",1e300],[\"Ks\",\"x\"],5,[\"Ns\",2]],\"textures\":["
                        + textures + "]}}}",
                "");
        assertThat(material(file).parameters()).isEqualTo(List.of(new Material.Parameter("Ns", 2)));
        assertThat(material(file).textures()).hasSize(4096);
        assertThat(file.notes().get(0))
                .matches(note -> note.count() == 7
                        && note.example().equals("material0: Kd")
                        && note.text().contains("material0: k4096"));
    }

    @Test
    void shouldFindTheFirstImageOfAName() throws IOException {
        ModelFile file = read(
                "{\"extras\":{\"jsm\":{\"parameters\":[],\"textures\":[[\"map_Kd\",\"n\"]]}}}",
                ",\"images\":[{\"name\":\"n\",\"bufferView\":1},{\"name\":\"n\",\"bufferView\":0}]");
        assertThat(file.mesh().textures().get(0).bytes()).containsExactly(1);
    }

    @Test
    void shouldShortenTheNameOfAnImageOnce() throws IOException {
        String material = "{\"normalTexture\":{\"index\":0}}";
        String rest = ",\"textures\":[{\"source\":0}],\"images\":[{\"bufferView\":1,\"name\":\"";
        ModelFile file = read(material, rest + "n".repeat(5000) + "\"}]");
        String path = file.mesh().textures().get(0).path();
        assertThat(path).isEqualTo("n".repeat(4032) + ".png");
        assertThat(file.notes()).hasSize(1);
        ModelFile again = read(material, rest + path + "\"}]");
        assertThat(again.mesh().textures().get(0).path()).isEqualTo(path);
        assertThat(again.notes()).isEmpty();
    }
}
