package org.jsmesh.files.gltf;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.io.ModelFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Parts that nobody uses may be as they like. */
class GltfLenienceTest {
    @ParameterizedTest
    @ValueSource(
            strings = {
                ",\"animations\":[],\"skins\":[],\"materials\":[],\"cameras\":[]",
                ",\"animations\":null,\"skins\":null,\"samplers\":{},\"images\":7,\"textures\":\"x\"",
                ",\"animations\":[{\"samplers\":[{\"interpolation\":\"CATMULLROMSPLINE\"}],\"channels\":[{\"target\":{\"path\":\"pointer\"}}]}]",
                ",\"cameras\":[{\"type\":\"panoramic\"}]",
                ",\"samplers\":[{\"wrapS\":5,\"magFilter\":\"x\"}],\"materials\":[{\"alphaMode\":\"mask\",\"emissiveFactor\":[9]}]",
                ",\"skins\":[{\"joints\":[null,99],\"inverseBindMatrices\":-1}]",
                ",\"images\":[{\"bufferView\":99},null,{\"uri\":\"gone.png\"}],\"textures\":[{\"source\":0}]",
                ",\"extensionsUsed\":[],\"extensionsRequired\":null,\"extras\":[null]"
            })
    void shouldReadAFileWhateverIsInPartsThatAreNotUsed(String rest) throws IOException {
        ModelFile file = GlbBuilder.triangle().rest(rest).read();
        assertThat(file.mesh().faces()).isEqualTo(1);
        assertThat(file.notes()).noneMatch(Note::warning);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "{\"mesh\":0,\"children\":[]}",
                "{\"mesh\":0,\"children\":null,\"matrix\":null,\"rotation\":[],\"weights\":{}}",
                "{\"mesh\":0,\"camera\":\"x\",\"skin\":null,\"name\":4,\"extensions\":3}",
                "{\"children\":[null,1],\"mesh\":null},{\"mesh\":0}"
            })
    void shouldReadNodesWithEmptyOrUnusedProperties(String nodes) throws IOException {
        assertThat(GlbBuilder.triangle().nodes(nodes).read().mesh().faces()).isEqualTo(1);
    }

    @ParameterizedTest
    @ValueSource(strings = {"{}", "{\"a\":0}", "7", "null", "[]", "[null]"})
    void shouldReadAMeshWithOddWeights(String weights) throws IOException {
        assertThat(GlbBuilder.triangle().mesh(",\"weights\":" + weights).read().notes())
                .isEmpty();
    }

    @Test
    void shouldNotLookAtTheRangesOfAccessors() throws IOException {
        GlbBuilder builder = new GlbBuilder();
        builder.accessor(
                new byte[36],
                5126,
                "VEC3",
                3,
                ",\"min\":[\"a\"],\"max\":[1],\"name\":[],\"sparse\":null,\"normalized\":1");
        ModelFile file = builder.primitive("{\"attributes\":{\"POSITION\":0},\"targets\":[],\"material\":null}")
                .mesh(",\"weights\":[]")
                .read();
        assertThat(file.mesh().faces()).isEqualTo(1);
        assertThat(file.notes()).isEmpty();
    }

    @Test
    void shouldReadPositionsWithoutBytesAsZeros() throws IOException {
        ModelFile file = new GlbBuilder()
                .accessorText("{\"componentType\":5126,\"type\":\"VEC3\",\"count\":3}")
                .primitive("{\"attributes\":{\"POSITION\":0}}")
                .read();
        assertThat(GltfChannels.position(file.mesh(), 0, 2)).containsExactly(0., 0., 0.);
    }

    @Test
    void shouldReadTextBehindAByteOrderMark() throws IOException {
        GlbBuilder builder = GlbBuilder.triangle();
        String uri = "data:;base64," + java.util.Base64.getEncoder().encodeToString(builder.binary());
        byte[] content = ("\uFEFF" + builder.gltf(uri)).getBytes(java.nio.charset.StandardCharsets.UTF_8);
        assertThat(GltfReader.read("a.gltf", content, path -> java.util.Optional.empty())
                        .mesh()
                        .faces())
                .isEqualTo(1);
    }
}
