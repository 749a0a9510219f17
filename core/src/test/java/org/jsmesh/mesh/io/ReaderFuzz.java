package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jsmesh.mesh.Mesh;

/** What every reader owes to any bytes: a mesh of a size that the bytes can hold, or a ModelFormatException. */
final class ReaderFuzz {
    private static final byte[] LIBRARY =
            "newmtl a\nKd 1 0 0\nmap_Kd -s 1 1 1 a.png\nnewmtl b\nillum 2\n".getBytes(StandardCharsets.UTF_8);

    private ReaderFuzz() {}

    /** Reads bytes as a file of the given name; what is a mesh is written and read again. */
    static void read(String fileName, byte[] content) throws IOException {
        ModelFile model;
        try {
            model = ModelReader.read(fileName, content, ReaderFuzz::resource);
        } catch (ModelFormatException e) {
            assertThat(e.reason()).isNotBlank();
            assertThat(e.remedy()).isNotBlank();
            return;
        }
        Mesh mesh = model.mesh();
        assertThat(mesh.vertices()).isLessThanOrEqualTo(content.length);
        assertThat(mesh.faces()).isLessThanOrEqualTo(content.length);
        for (float value : mesh.positions()) assertThat(value).isFinite();
        MemoryFiles files = new MemoryFiles();
        List<String> notes = new ArrayList<>(ModelWriter.write(
                mesh, model.format(), "again." + model.format().extension(), files));
        Mesh again = files.read("again." + model.format().extension()).mesh();
        if (notes.isEmpty()) assertThat(again.faces()).isEqualTo(mesh.faces());
    }

    private static Optional<byte[]> resource(String path) {
        return path.startsWith("l") ? Optional.of(LIBRARY) : Optional.empty();
    }
}
