package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshComparison;
import org.jsmesh.mesh.Note;
import org.junit.jupiter.api.Test;

class StlColoursTest {
    /** @param header ISO 8859-1, so that any byte can be in it */
    private static byte[] facets(String header, int... words) {
        ByteBuffer data = ByteBuffer.allocate(84 + 50 * words.length).order(ByteOrder.LITTLE_ENDIAN);
        data.put(header.getBytes(StandardCharsets.ISO_8859_1)).position(80).putInt(words.length);
        for (int i = 0; i < words.length; i++) {
            data.position(84 + 50 * i + 12);
            for (float value : new float[] {i, 0, 0, i + 1, 0, 0, i, 1, 0}) data.putFloat(value);
            data.putShort((short) words[i]);
        }
        return data.array();
    }

    private static ModelFile read(byte[] content) throws IOException {
        return ModelReader.read("a.stl", content, ResourceResolver.NONE);
    }

    private static byte[] written(Mesh mesh, String... losses) throws IOException {
        MemoryFiles files = new MemoryFiles();
        assertThat(ModelWriter.write(mesh, ModelFormat.STL, "b.stl", files)).containsExactly(losses);
        return files.files().get("b.stl");
    }

    @Test
    void shouldReadColoursOfVisCamAndWriteThemBack() throws IOException {
        ModelFile file = read(facets("x", 0xFC00, 0, 0x8000 | 31, 0xFC00, 0x8000 | 31 << 5));
        Mesh mesh = file.mesh();
        assertThat(mesh.faceMaterials()).containsExactly(0, -1, 1, 0, 2);
        assertThat(mesh.materials().get(0).parameter("rgb")).containsExactly(1, 0, 0);
        assertThat(mesh.materials().get(1).parameter("rgb")).containsExactly(0, 0, 1);
        assertThat(mesh.materials().get(2).parameter("rgb")).containsExactly(0, 1, 0);
        assertThat(file.notes()).isEmpty();
        byte[] again = written(mesh);
        assertThat(ByteBuffer.wrap(again).order(ByteOrder.LITTLE_ENDIAN).getShort(84 + 48))
                .isEqualTo((short) 0xFC00);
        assertThat(MeshComparison.firstDifference(mesh, read(again).mesh())).isEmpty();
    }

    @Test
    void shouldReadColoursOfMagics() throws IOException {
        ModelFile file = read(facets("COLOR=\u00ff\u0033\u0000\u0066", 0xFFFF, 31, 31 << 10, 0));
        Mesh mesh = file.mesh();
        assertThat(mesh.faceMaterials()).containsExactly(0, 1, 2, 3);
        assertThat(mesh.materials())
                .extracting(m -> DisplayMaterial.of(m, false).plain())
                .containsExactly(
                        new float[] {1, .2f, 0, .4f}, new float[] {1, 0, 0, 1}, new float[] {0, 0, 1, 1}, new float[] {
                            0, 0, 0, 1
                        });
        assertThat(file.notes()).isEmpty();
    }

    @Test
    void shouldGiveTheColourOfTheHeaderToAllFacetsWithoutWordsAndWriteItBack() throws IOException {
        ModelFile file = read(facets("COLOR=\u00ff\u0033\u0000\u0066,MATERIAL=\u0001\u0002", 0, 0));
        assertThat(file.mesh().faceMaterials()).containsExactly(0, 0);
        assertThat(DisplayMaterial.of(file.mesh().materials().get(0), false).plain())
                .containsExactly(1, .2f, 0, .4f);
        assertThat(file.notes())
                .containsExactly(Note.dropped("The header's specular and ambient colour not kept.", 1, "byte 0"));
        assertThat(MeshComparison.firstDifference(
                        file.mesh(), read(written(file.mesh())).mesh()))
                .isEmpty();
    }

    @Test
    void shouldKeepOtherWordsByFaceAndWriteThemBack() throws IOException {
        ModelFile file = read(facets("x", 0, 7, 0x8001));
        assertThat(file.mesh().materials()).isEmpty();
        assertThat(file.notes()).isEmpty();
        FaceChannel words = file.mesh().faceChannels().get(0);
        assertThat(words.name()).isEqualTo("attribute");
        assertThat(words.type()).isEqualTo(Channel.Type.UINT16);
        assertThat(words.values()).containsExactly(0, 7, 0x8001);
        assertThat(MeshComparison.firstDifference(
                        file.mesh(), read(written(file.mesh())).mesh()))
                .isEmpty();
    }

    @Test
    void shouldSayThatColoursAreRounded() throws IOException {
        Mesh mesh = Reading.read("a.off", "OFF", "3 2 0", "0 0 0", "1 0 0", "0 1 0", "3 0 1 2 .5 0 0", "3 2 1 0 1 1 1.")
                .mesh();
        byte[] content = written(mesh, "STL holds colours of 5 bits without opacity: they are rounded.");
        assertThat(read(content).mesh().materials().get(0).parameter("rgb")).containsExactly(16 / 31f, 0, 0);
    }
}
