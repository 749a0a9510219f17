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
                        "x: the content is of no known format. Give a PLY, OBJ, STL, OFF, Hoppe .m, GLB, glTF or 3MF file.");
        assertThat(Reading.refusal("x.obj", new byte[0])).hasMessageStartingWith("x.obj: the file is empty.");
    }

    @ParameterizedTest
    @CsvSource({
        "UTF-16LE,UTF-16,''",
        "UTF-16BE,UTF-16,''",
        "UTF-16,UTF-16,''",
        "UTF-16LE,UTF-16,'\uFEFF'",
        "UTF-32LE,UTF-32,''",
        "UTF-32BE,UTF-32,''",
        "UTF-32LE,UTF-32,'\uFEFF'",
        "UTF-32BE,UTF-32,'\uFEFF'"
    })
    void shouldNameTextOfWideLetters(String encoding, String name, String mark) {
        for (String text : new String[] {"ply\nformat ascii 1.0\n", "v 0 0 0\n", "OFF\n3 1 0\n", "\tsolid x\r\n"}) {
            byte[] content = (mark + text).getBytes(java.nio.charset.Charset.forName(encoding));
            assertThat(Reading.refusal("a.ply", content))
                    .hasMessage("a.ply: the text is " + name
                            + ". Save it as UTF-8 or ASCII in an editor, or export it anew.");
        }
    }

    @Test
    void shouldNamePackedContent() {
        byte[] gzip = new byte[30];
        gzip[0] = 0x1F;
        gzip[1] = (byte) 0x8B;
        gzip[2] = 8;
        assertThat(Reading.refusal("a.ply", gzip).reason()).isEqualTo("the content is compressed with gzip");
        byte[] zip = java.util.Arrays.copyOf(new byte[] {'P', 'K', 3, 4}, 30);
        assertThat(Reading.refusal("a.ply", zip).reason()).isEqualTo("the content is a ZIP archive");
    }

    @Test
    void shouldTellFormatsForWritingFromNames() {
        assertThat(ModelFormat.ofName("A.PLY.GZ")).isEqualTo(ModelFormat.PLY);
        assertThat(ModelFormat.ofName("a.gltf.gz")).isEqualTo(ModelFormat.GLB);
        assertThat(ModelFormat.ofName("a.txt.gz")).isNull();
        assertThat(ModelFormat.toWrite("a.ply.gz")).isNull();
        assertThat(ModelFormat.ofName("A.PLY")).isEqualTo(ModelFormat.PLY);
        assertThat(ModelFormat.ofName("a.b.m")).isEqualTo(ModelFormat.HOPPE_M);
        assertThat(ModelFormat.ofName("a.gltf")).isEqualTo(ModelFormat.GLB);
        assertThat(ModelFormat.toWrite("a.GLB")).isEqualTo(ModelFormat.GLB);
        assertThat(ModelFormat.toWrite("a.gltf")).isNull();
        assertThat(ModelFormat.ofName("a.3MF")).isEqualTo(ModelFormat.THREE_MF);
        assertThat(ModelFormat.toWrite("a.3mf")).isNull();
        assertThat(ModelFormat.ofName("obj")).isNull();
    }
}
