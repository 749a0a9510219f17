package org.jsmesh.files.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.Texture;
import org.jsmesh.mesh.io.ModelFile;
import org.jsmesh.mesh.io.ModelFormatException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Bytes beside a file and within it, and the text of the file itself. */
class GltfResourcesTest {
    private static final String TEXTURED =
            ",\"materials\":[{\"normalTexture\":{\"index\":0}}],\"textures\":[{\"source\":0}],\"images\":[";

    private final List<String> asked = new ArrayList<>();

    private static GlbBuilder textured(String image) {
        GlbBuilder builder = new GlbBuilder();
        builder.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
        return builder.primitive("{\"attributes\":{\"POSITION\":0},\"material\":0}")
                .rest(TEXTURED + image + "]");
    }

    private ModelFile read(byte[] content, Map<String, byte[]> files) throws IOException {
        return GltfReader.read("a.gltf", content, path -> {
            asked.add(path);
            return Optional.ofNullable(files.get(path));
        });
    }

    private static byte[] utf8(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    @ParameterizedTest
    @CsvSource({"a%2520b.png,a%20b.png", "data%3A%2C1.png,'data:,1.png'"})
    void shouldDecodeThePathOfAnImageOnce(String uri, String path) throws IOException {
        ModelFile file = read(textured("{\"uri\":\"" + uri + "\"}").glb(), Map.of(path, new byte[] {5}));
        assertThat(file.mesh().textures()).extracting(Texture::path).containsExactly(path);
        assertThat(file.mesh().textures().get(0).bytes()).containsExactly(5);
        assertThat(file.notes()).isEmpty();
    }

    @Test
    void shouldTakeThePathOfADefinitionOfAnotherFormatAsItIs() throws IOException {
        String material = "{\"extras\":{\"jsm\":{\"parameters\":[],\"textures\":[[\"map_Kd\",\"50%25.png\"]]}}}";
        GlbBuilder builder = textured("").rest(",\"materials\":[" + material + "]");
        ModelFile file = read(builder.glb(), Map.of("50%25.png", new byte[] {5}));
        assertThat(file.mesh().textures()).hasSize(1);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "{\"uri\":\"data:image/png;base64,A\"}",
                "{\"uri\":\"data:image/png\"}",
                "{\"bufferView\":99}",
                "{\"bufferView\":\"x\"}"
            })
    void shouldLeaveOutAnImageThatCannotBeRead(String image) throws IOException {
        ModelFile file = textured(image).read();
        assertThat(file.mesh().faces()).isEqualTo(1);
        assertThat(file.mesh().textures()).isEmpty();
        assertThat(file.notes())
                .containsExactly(
                        Note.dropped("Images without bytes that can be read left out: image0.png.", 1, "image0.png")
                                .asWarning());
    }

    @Test
    void shouldReadAnImageOfEscapedBytes() throws IOException {
        ModelFile file = textured("{\"uri\":\"data:image/png,%89PNG\"}").read();
        assertThat(file.mesh().textures().get(0).bytes()).containsExactly(0x89, 'P', 'N', 'G');
    }

    @Test
    void shouldReadAFileOfManyBuffersOnce() throws IOException {
        GlbBuilder builder = GlbBuilder.triangle();
        String second = builder.gltf("a.bin")
                .replace("\"buffers\":[", "\"buffers\":[{\"byteLength\":76,\"uri\":\"a.bin\"},")
                .replaceFirst("\"buffer\":0", "\"buffer\":1");
        assertThat(read(utf8(second), Map.of("a.bin", builder.binary())).mesh().faces())
                .isEqualTo(1);
        assertThat(asked).containsExactly("a.bin");
    }

    @Test
    void shouldReadABufferOfMoreThanTwentyMillionCharacters() throws IOException {
        GlbBuilder builder = GlbBuilder.triangle();
        builder.view(new byte[15_100_000]);
        String uri =
                "data:application/octet-stream;base64," + Base64.getEncoder().encodeToString(builder.binary());
        assertThat(read(utf8(builder.gltf(uri)), Map.of()).mesh().faces()).isEqualTo(1);
    }

    @Test
    void shouldReadAVersionThatIsANumber() throws IOException {
        GlbBuilder builder = GlbBuilder.triangle();
        String json = builder.gltf("a.bin").replace("\"2.0\"", "2");
        assertThat(read(utf8(json), Map.of("a.bin", builder.binary())).mesh().faces())
                .isEqualTo(1);
    }

    @Test
    void shouldNameTheLineWhereTheTextEnds() {
        assertThatThrownBy(() -> read(utf8("{\"asset\":{\"version\":\"2.0\"},\n\"x\":[1,2"), Map.of()))
                .isInstanceOf(ModelFormatException.class)
                .hasMessage(
                        "a.gltf, line 2 of the JSON: the JSON is damaged: the text ends in the middle of a value. Export the model again.");
    }
}
