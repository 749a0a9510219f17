package org.jsmesh.files.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.jsmesh.files.gltf.GltfChannels.at;
import static org.jsmesh.files.gltf.GltfChannels.named;
import static org.jsmesh.files.gltf.GltfChannels.position;

import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshComparison;
import org.jsmesh.mesh.io.ModelFile;
import org.jsmesh.mesh.io.ModelFormatException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Compressed geometry: a unit square of four vertices and the triangles 0 1 2 and 2 1 3, which the encoders of
 * meshoptimizer and Draco packed.
 */
class GltfPackedTest {
    private static final byte[] POSITIONS =
            bytes("oAAAAT8AAAD///8BPwAAAH59fgAAAQwAAAD/AQwAAAB+AAAAAAAAAAAAAAAA" + "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA");

    private static final byte[] TRIANGLES = bytes("4fAQAHaHVmd4qYZliWiYAWkAAA==");

    /** With normalized colours of bytes as attribute 1. */
    private static final byte[] DRACO = bytes("RFJBQ08CAgEAAAACBAEAAQICAQMBAgAJAwAAAgIEAAEAAQAAAAAAAAAAAAAAAAAAgD8AAAAA"
            + "AAAAAAAAAAAAAIA/AAAAAAAAgD8AAIA/AAAAAAABAQAJAwEQASATARADAJCQaYBhxrxcBgAAAAD/AAAA");

    private static byte[] bytes(String base64) {
        return Base64.getDecoder().decode(base64);
    }

    private static void isTheSquare(Mesh mesh) {
        assertThat(mesh.faces()).isEqualTo(2);
        assertThat(mesh.vertices()).isEqualTo(4);
        assertThat(position(mesh, 0, 0)).containsExactly(0., 0., 0.);
        assertThat(position(mesh, 0, 1)).containsExactly(1., 0., 0.);
        assertThat(position(mesh, 0, 2)).containsExactly(0., 1., 0.);
        assertThat(position(mesh, 1, 2)).containsExactly(1., 1., 0.);
    }

    private static GlbBuilder meshopt(String extension, byte[] positions) {
        GlbBuilder builder = new GlbBuilder();
        int corners = builder.packedView(positions, extension, "ATTRIBUTES", 4, 12);
        int indices = builder.packedView(TRIANGLES, extension, "TRIANGLES", 6, 2);
        builder.accessorText("{\"bufferView\":" + corners + ",\"componentType\":5126,\"type\":\"VEC3\",\"count\":4}");
        builder.accessorText("{\"bufferView\":" + indices + ",\"componentType\":5123,\"type\":\"SCALAR\",\"count\":6}");
        return builder.primitive("{\"attributes\":{\"POSITION\":0},\"indices\":1}")
                .rest(",\"extensionsRequired\":[\"" + extension + "\"],\"extensionsUsed\":[\"" + extension + "\"]");
    }

    private static GlbBuilder draco(byte[] packed, String attributes) {
        GlbBuilder builder = new GlbBuilder();
        int view = builder.view(packed);
        builder.accessorText("{\"componentType\":5126,\"type\":\"VEC3\",\"count\":4}");
        builder.accessorText("{\"componentType\":5121,\"type\":\"VEC4\",\"count\":4,\"normalized\":true}");
        builder.accessorText("{\"componentType\":5123,\"type\":\"SCALAR\",\"count\":6}");
        return builder.primitive("{\"attributes\":{\"POSITION\":0,\"COLOR_0\":1},\"indices\":2,\"extensions\":"
                + "{\"KHR_draco_mesh_compression\":{\"bufferView\":" + view + ",\"attributes\":{" + attributes
                + "}}}}");
    }

    @ParameterizedTest
    @ValueSource(strings = {"EXT_meshopt_compression", "KHR_meshopt_compression"})
    void shouldUnpackBufferViewsOfMeshopt(String extension) throws IOException {
        ModelFile file = meshopt(extension, POSITIONS).read();
        isTheSquare(file.mesh());
        assertThat(file.notes()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                ",\"extensionsUsed\":[\"KHR_draco_mesh_compression\"]",
                ",\"extensionsRequired\":[\"KHR_draco_mesh_compression\"]"
            })
    void shouldUnpackDracoWhetherItIsRequiredOrNot(String extensions) throws IOException {
        ModelFile file =
                draco(DRACO, "\"POSITION\":0,\"COLOR_0\":1").rest(extensions).read();
        isTheSquare(file.mesh());
        assertThat(named(file.mesh(), "COLOR_0").type()).isEqualTo(Channel.Type.UINT8);
        assertThat(at(file.mesh(), "COLOR_0", 1, 2)).containsExactly(51., 102., 153., 204.);
        assertThat(file.notes()).isEmpty();
    }

    @Test
    void shouldTakePositionsThatAreThereInPlainFormToo() throws IOException {
        GlbBuilder builder = GlbBuilder.triangle();
        int view = builder.view(new byte[] {1, 2, 3});
        ModelFile file = builder.primitive(
                        "{\"attributes\":{\"POSITION\":0},\"extensions\":{\"KHR_draco_mesh_compression\":"
                                + "{\"bufferView\":" + view + ",\"attributes\":{\"POSITION\":0}}}}")
                .read();
        assertThat(file.mesh().faces()).isEqualTo(2);
    }

    @Test
    void shouldDropAttributesThatTheCompressedMeshLacks() throws IOException {
        ModelFile file = draco(DRACO, "\"POSITION\":0,\"COLOR_0\":9").read();
        isTheSquare(file.mesh());
        assertThat(file.mesh().channels()).isEmpty();
        assertThat(file.notes())
                .singleElement()
                .matches(note -> note.warning() && note.text().contains("COLOR_0"));
    }

    @Test
    void shouldRefuseDamagedDataByTheNameOfItsCompression() {
        byte[] cut = Arrays.copyOf(DRACO, 40);
        assertThatThrownBy(draco(cut, "\"POSITION\":0")::read)
                .isInstanceOf(ModelFormatException.class)
                .hasMessageContaining("compressed with KHR_draco_mesh_compression and cannot be unpacked")
                .hasMessageContaining("without mesh compression");
        byte[] shortened = Arrays.copyOf(POSITIONS, 20);
        assertThatThrownBy(meshopt("EXT_meshopt_compression", shortened)::read)
                .isInstanceOf(ModelFormatException.class)
                .hasMessageContaining("compressed with EXT_meshopt_compression and cannot be unpacked");
    }

    @Test
    void shouldRefuseViewsThatClaimToUnpackToMoreThanTheyCan() {
        GlbBuilder builder = new GlbBuilder();
        builder.packedView(POSITIONS, "EXT_meshopt_compression", "ATTRIBUTES", 1_000_000, 256);
        builder.accessorText("{\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\",\"count\":4}");
        assertThatThrownBy(() ->
                        builder.primitive("{\"attributes\":{\"POSITION\":0}}").read())
                .isInstanceOf(ModelFormatException.class)
                .hasMessageContaining("unpacks to more than");
    }

    private static ModelFile sample(String name) throws IOException {
        try (InputStream in = GltfPackedTest.class.getResourceAsStream("compressed/" + name + ".glb")) {
            return GltfReader.read(name + ".glb", in.readAllBytes(), path -> Optional.empty());
        }
    }

    /** Bounds, area, and the mean of the colours. */
    private static double[] measure(Mesh mesh) {
        double[] measure = {9, 9, 9, -9, -9, -9, 0, 0};
        for (int f = 0; f < mesh.faces(); f++) {
            double[][] p = new double[3][3];
            for (int i = 0; i < 9; i++) {
                double x = mesh.coordinate(mesh.vertex(f, i / 3), i % 3);
                p[i / 3][i % 3] = x;
                measure[i % 3] = Math.min(measure[i % 3], x);
                measure[3 + i % 3] = Math.max(measure[3 + i % 3], x);
                measure[7] += at(mesh, "COLOR_0", f, i / 3).get(i % 3) / 255 / 9 / mesh.faces();
            }
            double square = 0;
            for (int k = 0; k < 3; k++) {
                int l = (k + 1) % 3;
                double c = (p[1][k] - p[0][k]) * (p[2][l] - p[0][l]) - (p[1][l] - p[0][l]) * (p[2][k] - p[0][k]);
                square += c * c;
            }
            measure[6] += Math.sqrt(square) / 2;
        }
        return measure;
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "draco-required",
                "draco-optional",
                "meshopt-quantized",
                "meshopt-fallback",
                "meshopt-khr",
                "meshopt-floats"
            })
    void shouldReadWhatOtherProgramsCompressed(String name) throws IOException {
        ModelFile file = sample(name);
        Mesh plain = sample("plain").mesh();
        assertThat(file.mesh().faces()).isEqualTo(plain.faces());
        assertThat(measure(file.mesh())).containsExactly(measure(plain), within(.004));
        assertThat(file.mesh().textures().get(0).bytes())
                .isEqualTo(plain.textures().get(0).bytes());
        assertThat(file.notes()).isEmpty();
    }

    @Test
    void shouldUnpackFloatsToEveryBit() throws IOException {
        Mesh plain = sample("plain").mesh();
        Mesh packed = sample("meshopt-floats").mesh();
        int[] none = new int[plain.faces()];
        Arrays.fill(none, -1);
        assertThat(MeshComparison.firstDifference(
                        MeshBuilder.from(plain)
                                .materials(List.of())
                                .faceMaterials(none)
                                .build(),
                        MeshBuilder.from(packed)
                                .materials(List.of())
                                .faceMaterials(none)
                                .build()))
                .isEmpty();
    }
}
