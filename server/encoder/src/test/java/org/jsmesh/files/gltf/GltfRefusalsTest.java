package org.jsmesh.files.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.util.Arrays;
import java.util.Optional;
import org.jsmesh.mesh.io.ModelFormatException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What {@link GltfReader} refuses, with a reason and a remedy. */
class GltfRefusalsTest {
    @ParameterizedTest
    @ValueSource(
            strings = {
                "{\"mesh\":7}",
                "{\"children\":[5]}",
                "{\"children\":[0]}",
                "{\"children\":[1]},{\"children\":[0]}",
                "{\"mesh\":0,\"scale\":[1e300,1,1]}",
                "null",
                "{\"mesh\":0,\"matrix\":\"x\"}",
                "7"
            })
    void shouldRefuseBadNodes(String nodes) {
        assertRefused(GlbBuilder.triangle().nodes(nodes).glb());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "{\"componentType\":5126,\"type\":\"VEC3\",\"count\":2000000000}",
                "{\"componentType\":5126,\"type\":\"VEC3\",\"count\":-1}",
                "{\"componentType\":5126,\"type\":\"VEC3\"}",
                "{\"componentType\":5126,\"type\":\"MAT4\",\"count\":1}",
                "{\"componentType\":9,\"type\":\"VEC3\",\"count\":1}",
                "{\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\",\"count\":4}",
                "{\"bufferView\":9,\"componentType\":5126,\"type\":\"VEC3\",\"count\":3}",
                "{\"bufferView\":0,\"byteOffset\":-4,\"componentType\":5126,\"type\":\"VEC3\",\"count\":3}",
                "{\"bufferView\":0,\"byteOffset\":2147483647,\"componentType\":5126,\"type\":\"VEC3\",\"count\":3}",
                "{\"componentType\":5126,\"type\":\"VEC3\",\"count\":3,\"sparse\":{}}",
                "{\"componentType\":5126,\"type\":\"VEC3\",\"count\":3,\"sparse\":{\"count\":9,\"indices\":{\"bufferView\":0,\"componentType\":5121},\"values\":{\"bufferView\":0}}}"
            })
    void shouldRefuseBadAccessors(String accessor) {
        GlbBuilder builder = new GlbBuilder();
        builder.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
        assertRefused(builder.accessorText(accessor)
                .primitive("{\"attributes\":{\"POSITION\":1}}")
                .glb());
    }

    @Test
    void shouldRefuseNumbersThatAreNotFinite() {
        GlbBuilder builder = new GlbBuilder();
        builder.floats("VEC3", 0, 0, 0, 1, Float.NaN, 0, 0, 1, 0);
        assertThatThrownBy(() ->
                        builder.primitive("{\"attributes\":{\"POSITION\":0}}").read())
                .hasMessageContaining("accessor 0 has NaN at element 1, not a finite number");
    }

    @Test
    void shouldRefuseIndicesOutOfRange() {
        GlbBuilder builder = GlbBuilder.triangle();
        int indices = builder.bytes(5121, "SCALAR", 3, "", 0, 1, 3);
        assertThatThrownBy(() -> builder.primitive("{\"attributes\":{\"POSITION\":0},\"indices\":" + indices + "}")
                        .read())
                .hasMessageContaining("an index names vertex 3 of 3");
    }

    @Test
    void shouldRefuseRequiredExtensionsThatAreNotReadByName() {
        GlbBuilder builder = GlbBuilder.triangle()
                .rest(
                        ",\"extensionsRequired\":[\"KHR_materials_unlit\",\"ACME_mesh_folding\",\"KHR_texture_transform\"]");
        assertThatThrownBy(builder::read)
                .isInstanceOf(ModelFormatException.class)
                .hasMessageContaining("an extension of glTF that jSM does not read: ACME_mesh_folding")
                .hasMessageContaining("Export the model without it");
    }

    @Test
    void shouldRefuseMeshesThatAreThereInCompressedFormAlone() {
        GlbBuilder builder = new GlbBuilder();
        builder.view(new byte[4]);
        builder.accessorText("{\"componentType\":5126,\"type\":\"VEC3\",\"count\":3}")
                .primitive("{\"attributes\":{\"POSITION\":0},\"extensions\":{\"KHR_draco_mesh_compression\":"
                        + "{\"bufferView\":0,\"attributes\":{\"POSITION\":0}}}}")
                .rest(",\"extensionsUsed\":[\"KHR_draco_mesh_compression\"]");
        assertThatThrownBy(builder::read)
                .hasMessageContaining("KHR_draco_mesh_compression")
                .hasMessageContaining("without mesh compression");
    }

    @Test
    void shouldRefuseEveryTruncationAndEveryGarbledByte() {
        byte[] glb = GlbBuilder.triangle().glb();
        for (int length = 0; length < glb.length; length++) assertRefused(Arrays.copyOf(glb, length));
        for (int i = 0; i < glb.length; i++) {
            byte[] garbled = glb.clone();
            garbled[i] ^= 0x55;
            readOrRefuse(garbled);
        }
    }

    private static void assertRefused(byte[] content) {
        ModelFormatException refusal = catchThrowableOfType(
                ModelFormatException.class, () -> GltfReader.read("a.glb", content, p -> Optional.empty()));
        assertThat(refusal).isNotNull();
        assertThat(refusal.remedy()).isNotBlank();
    }

    private static void readOrRefuse(byte[] content) {
        try {
            GltfReader.read("a.glb", content, p -> Optional.empty());
        } catch (ModelFormatException e) {
            assertThat(e.reason()).isNotBlank();
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }
}
