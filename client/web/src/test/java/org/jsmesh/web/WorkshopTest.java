package org.jsmesh.web;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.ByteBuffer;
import java.util.LinkedHashSet;
import java.util.Set;
import org.jsmesh.mesh.MalformedStreamException;
import org.junit.jupiter.api.Test;

class WorkshopTest {
    private static final String OBJ =
            "mtllib Materials\\pyramid.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1.25\n"
                    + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

    private final Workshop workshop = new Workshop();
    private final Set<String> stages = new LinkedHashSet<>();

    @Test
    void shouldEncodeAModelWithItsCompanionsAndWriteItAgain() throws MalformedStreamException {
        give("scans/pyramid.obj", OBJ);
        give("scans/materials/Pyramid.mtl", "newmtl red\nKd 1 0 0\n");
        assertThat(encode("scans/pyramid.obj", 4)).contains("\"name\":\"scans/pyramid.jsm\"");
        assertThat(stages).startsWith("reading").hasSizeGreaterThan(2);

        byte[] archive = workshop.file(0);
        workshop.begin("archive.jsm", archive.length);
        workshop.append(ByteBuffer.wrap(archive), archive.length);
        Json json = new Json();
        workshop.decode("archive.jsm", "again.obj", json);
        assertThat(json.toString()).contains("\"again.obj\"", "\"again.mtl\"", "\"notes\":[]");
        assertThat(new String(workshop.file(0), UTF_8)).contains("usemtl red", "v 0 0 1.25");
        assertThat(new String(workshop.file(1), UTF_8)).contains("Kd 1 0 0");
    }

    @Test
    void shouldSayWhyAModelIsNotEncodedHere() {
        give("bad.obj", "v 0 0 0\nv 1 0 x\n");
        assertThatThrownBy(() -> encode("bad.obj", 9))
                .hasMessageStartingWith("bad.obj, line 2: ")
                .hasMessageEndingWith(".");
        give("pyramid.obj", OBJ);
        assertThatThrownBy(() -> encode("pyramid.obj", 3))
                .hasMessageStartingWith("pyramid.obj has 4 faces, and a browser encodes at most 3. Encode it with");
        give("duck.glb", "glTF\2\0\0\0\14\0\0\0");
        assertThatThrownBy(() -> encode("duck.glb", 9))
                .hasMessageStartingWith("A browser does not read glTF. Encode it with");
        give("empty.obj", "");
        assertThatThrownBy(() -> encode("empty.obj", 9)).hasMessageContaining("the file is empty");
    }

    @Test
    void shouldRefuseCutArchives() {
        give("pyramid.obj", OBJ);
        encode("pyramid.obj", 4);
        byte[] archive = workshop.file(0);
        workshop.begin("cut.jsm", archive.length - 1);
        workshop.append(ByteBuffer.wrap(archive), archive.length - 1);
        assertThatThrownBy(() -> workshop.decode("cut.jsm", "cut.ply", new Json()))
                .isInstanceOf(MalformedStreamException.class)
                .hasMessageContaining("the file ends before the original is there");
    }

    @Test
    void shouldRefuseCallsInTheWrongOrder() {
        assertThatThrownBy(() -> encode("none.ply", 9)).isInstanceOf(WrongCallException.class);
        assertThatThrownBy(() -> workshop.file(0)).isInstanceOf(WrongCallException.class);
        assertThatThrownBy(() -> workshop.begin("a", -1)).isInstanceOf(WrongCallException.class);
        assertThatThrownBy(() -> workshop.append(ByteBuffer.allocate(8), 1)).isInstanceOf(WrongCallException.class);
        give("a.jsm", "");
        assertThatThrownBy(() -> workshop.decode("a.jsm", "a.glb", new Json())).isInstanceOf(WrongCallException.class);
    }

    private void give(String path, String text) {
        byte[] bytes = text.getBytes(UTF_8);
        workshop.begin(path, bytes.length);
        workshop.append(ByteBuffer.wrap(bytes), bytes.length);
    }

    private String encode(String model, int mostFaces) {
        Json json = new Json();
        workshop.encode(model, mostFaces, (stage, fraction) -> stages.add(stage), json);
        return json.toString();
    }
}
