package org.jsmesh.files.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Optional;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.io.ModelFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What a file has and a mesh does not keep is told. */
class GltfDroppedTest {
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                ",\"materials\":[{\"name\":\"spare\"},{}]|Materials that no face has dropped: spare, material1.|2|spare",
                ",\"cameras\":[{\"type\":\"perspective\"},{\"name\":\"eye\"}]|Cameras dropped: camera 0, eye.|2|camera 0",
                ",\"extras\":{\"a\":1}|Extras dropped: file.|1|file"
            })
    void shouldTellOfPartsOfTheFile(String rest, String text, int count, String example) throws IOException {
        assertThat(GlbBuilder.triangle().rest(rest).read().notes()).containsExactly(Note.dropped(text, count, example));
    }

    @Test
    void shouldTellOfExtrasOfNodesScenesAndMeshes() throws IOException {
        ModelFile file = edited(
                GlbBuilder.triangle()
                        .nodes("{\"mesh\":0,\"extras\":{\"k\":1}},{\"extras\":{}},{\"extras\":{\"jsm\":{}}}")
                        .mesh(",\"extras\":[1]"),
                Map.of("{\"nodes\":[0]}", "{\"nodes\":[0],\"extras\":7}", "\"2.0\"", "\"2.0\",\"extras\":{\"z\":1}"));
        assertThat(file.notes())
                .containsExactly(Note.dropped("Extras dropped: asset, scene 0, node 0, mesh 0.", 4, "asset"));
    }

    @Test
    void shouldTellOfMetadataButNotOfTheProgram() throws IOException {
        ModelFile file = edited(
                GlbBuilder.triangle(),
                Map.of("\"2.0\"", "\"2.0\",\"generator\":\"g\",\"minVersion\":\"2.0\",\"copyright\":\"me\""));
        assertThat(file.notes())
                .containsExactly(Note.dropped("Metadata of the file dropped: copyright me.", 1, "copyright me"));
    }

    private static ModelFile edited(GlbBuilder builder, Map<String, String> changes) throws IOException {
        String json = builder.gltf("a.bin");
        for (Map.Entry<String, String> change : changes.entrySet()) {
            assertThat(json).contains(change.getKey());
            json = json.replace(change.getKey(), change.getValue());
        }
        return GltfReader.read("a.gltf", json.getBytes(StandardCharsets.UTF_8), path -> Optional.of(builder.binary()));
    }

    @Test
    void shouldTellOfExtensionsThatTheFileDoesNotList() throws IOException {
        GlbBuilder builder = new GlbBuilder();
        builder.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
        ModelFile file = builder.primitive(
                        "{\"attributes\":{\"POSITION\":0},\"extensions\":{\"KHR_materials_variants\":{}}}")
                .nodes("{\"mesh\":0,\"extensions\":{\"KHR_lights_punctual\":{},\"KHR_node_visibility\":{}}}")
                .rest(",\"extensions\":{\"KHR_xmp\":{}},\"extensionsUsed\":[\"KHR_xmp\"]")
                .read();
        assertThat(file.notes())
                .containsExactly(Note.unread(
                        "Extensions not read: KHR_lights_punctual, KHR_materials_variants, KHR_xmp.",
                        3,
                        "KHR_lights_punctual"));
    }

    @Test
    void shouldRefuseAnUnknownExtensionOfMaterialsWhenItIsRequired() throws IOException {
        String name = "[\"KHR_materials_nonsense\"]";
        assertThat(GlbBuilder.triangle()
                        .rest(",\"extensionsUsed\":" + name)
                        .read()
                        .notes())
                .isEmpty();
        assertThatThrownBy(() -> GlbBuilder.triangle()
                        .rest(",\"extensionsRequired\":" + name)
                        .read())
                .hasMessageContaining("does not read: KHR_materials_nonsense");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "KHR_materials_ior",
                "KHR_materials_pbrSpecularGlossiness",
                "EXT_materials_bump",
                "KHR_materials_variants"
            })
    void shouldReadAFileThatRequiresAKnownExtensionOfMaterials(String name) throws IOException {
        assertThat(GlbBuilder.triangle()
                        .rest(",\"extensionsRequired\":[\"" + name + "\"]")
                        .read()
                        .mesh()
                        .faces())
                .isEqualTo(1);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "\"bufferView\":77,\"componentType\":5126",
                "\"bufferView\":0,\"componentType\":5130",
                "\"bufferView\":0,\"byteOffset\":30,\"componentType\":5126",
                "\"count\":99000000,\"componentType\":5126"
            })
    void shouldDropAnAttributeThatCannotBeRead(String accessor) throws IOException {
        GlbBuilder builder = new GlbBuilder();
        builder.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
        String count = accessor.contains("count") ? "" : ",\"count\":3";
        ModelFile file = builder.accessorText("{" + accessor + ",\"type\":\"VEC3\"" + count + "}")
                .primitive("{\"attributes\":{\"POSITION\":0,\"NORMAL\":1}}")
                .read();
        assertThat(file.mesh().channels()).isEmpty();
        assertThat(file.notes())
                .containsExactly(Note.dropped(
                                "Vertex attributes of a kind or a length that does not fit dropped: NORMAL.",
                                1,
                                "NORMAL")
                        .asWarning());
    }

    @Test
    void shouldShortenNamesThatAnArchiveDoesNotHold() throws IOException {
        GlbBuilder builder = new GlbBuilder();
        builder.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
        ModelFile file = builder.primitive("{\"attributes\":{\"POSITION\":0},\"material\":0}")
                .nodes("{\"mesh\":0,\"name\":\"" + "x" + "é".repeat(2048) + "\"}")
                .rest(",\"materials\":[{\"name\":\"" + "m".repeat(4097) + "\"}]")
                .read();
        assertThat(file.mesh().materials().get(0).name()).isEqualTo("m".repeat(4096));
        assertThat(file.mesh().faceChannel(FaceChannel.OBJECT).labels()).containsExactly("x" + "é".repeat(2047));
        assertThat(file.notes())
                .singleElement()
                .matches(note -> note.kind() == Note.Kind.CHANGED
                        && note.count() == 2
                        && note.text().startsWith("Names longer than an archive holds shortened: xé"));
    }
}
