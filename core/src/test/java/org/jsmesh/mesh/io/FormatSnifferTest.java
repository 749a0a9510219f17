package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FormatSnifferTest {
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "ply/format ascii 1.0|PLY",
                "# hello/v 0 0 0|OBJ",
                "mtllib a|OBJ",
                "solid x/facet|STL",
                "OFF/3 1 0|OFF",
                "# c/COFF|OFF",
                "8 6 12/0 0 0|OFF",
                "# c/Vertex 1 0 0 0|HOPPE_M",
                "glTF....|GLB",
                "{ \"asset\": {}}|GLB"
            })
    void shouldTellTheFormatFromTheContentWhateverTheName(String content, ModelFormat format) throws IOException {
        for (String name : new String[] {"x.stl", "x", "x.obj"}) {
            assertThat(ModelReader.formatOf(name, content.replace('/', '\n').getBytes(StandardCharsets.UTF_8)))
                    .isEqualTo(format);
        }
    }

    @Test
    void shouldSkipAByteOrderMark() throws IOException {
        assertThat(Reading.read("x", "\uFEFFv 0 0 0", "v 1 0 0", "v 0 1 0", "f 1 2 3")
                        .mesh()
                        .faces())
                .isEqualTo(1);
    }

    @Test
    void shouldSayWhichFormatsThereAre() {
        assertThat(Reading.refusal("x", "hello"))
                .hasMessage(
                        "x: the content is of no known format. Give a PLY, OBJ, STL, OFF, Hoppe .m, GLB or glTF file.");
        assertThat(Reading.refusal("x.obj", new byte[0])).hasMessageStartingWith("x.obj: the file is empty.");
    }

    @Test
    void shouldTellFormatsForWritingFromNames() {
        assertThat(ModelFormat.ofName("A.PLY")).isEqualTo(ModelFormat.PLY);
        assertThat(ModelFormat.ofName("a.b.m")).isEqualTo(ModelFormat.HOPPE_M);
        assertThat(ModelFormat.ofName("a.gltf")).isEqualTo(ModelFormat.GLB);
        assertThat(ModelFormat.toWrite("a.GLB")).isEqualTo(ModelFormat.GLB);
        assertThat(ModelFormat.toWrite("a.gltf")).isNull();
        assertThat(ModelFormat.ofName("obj")).isNull();
    }
}
