package org.jsmesh.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.jsmesh.archive.ImageInfo;
import org.jsmesh.archive.Provenance;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.mesh.io.ModelReader;
import org.jsmesh.mesh.io.ResourceResolver;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ModelExportTest {
    private static final String OBJ = """
            mtllib wood.mtl
            v 0 0 0
            v 1 0 0
            v 0 1 0
            vt 0 0
            vt 1 0
            vt 0 1
            usemtl wood
            f 1/1 2/2 3/3
            """;

    @TempDir
    private Path folder;

    @Test
    void shouldWriteWhatTheNameSays() throws IOException {
        Path file = folder.resolve("a.obj");
        Mesh mesh = mesh();
        assertThat(ModelExport.to(file).write(mesh, UpAxis.UNKNOWN).losses()).isEmpty();
        assertThat(MeshIdentity.sha256(ModelFiles.read(file).mesh())).isEqualTo(MeshIdentity.sha256(mesh));
    }

    @Test
    void shouldSayWhyNothingIsWrittenUnderAName() {
        assertThatThrownBy(() -> ModelExport.to(Path.of("a.gltf")))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("name it .glb");
        assertThatThrownBy(() -> ModelExport.to(Path.of("a.3mf"))).hasMessageContaining("choose glb or obj");
        assertThatThrownBy(() -> ModelExport.to(Path.of("a.txt"))).hasMessageContaining("no known extension");
    }

    @Test
    void shouldClaimNoMoreThanWasWritten() {
        Provenance whole = new Provenance("OBJ", List.of());
        Provenance lacking = new Provenance(
                "OBJ", List.of(Note.dropped("3 parts missing.", 3, "").asWarning()));
        assertThat(ModelExport.claim(List.of(), whole)).startsWith("identical");
        assertThat(ModelExport.claim(List.of("No materials."), whole))
                .isEqualTo("every face of the original, but: No materials.");
        assertThat(ModelExport.claim(List.of("No materials."), lacking))
                .startsWith("every face of the archive, but: No materials. warning: ")
                .contains("3 parts missing");
    }

    @Test
    void shouldNameImagesThatHaveNotCome() throws IOException {
        List<ImageInfo> images = List.of(new ImageInfo(List.of("wood.png"), 100));
        assertThat(ModelExport.to(Path.of("a.obj")).missing(mesh(), images))
                .startsWith("1 image that it refers to comes later in the archive and is not written: wood.png. Ask ");
        assertThat(ModelExport.to(Path.of("a.stl")).missing(mesh(), images)).isEmpty();
        assertThat(ModelExport.to(Path.of("a.obj")).missing(mesh(), List.of())).isEmpty();
    }

    private static Mesh mesh() throws IOException {
        ResourceResolver library = path -> java.util.Optional.of("newmtl wood\nmap_Kd wood.png\n".getBytes())
                .filter(bytes -> path.equals("wood.mtl"));
        return ModelReader.read("a.obj", OBJ.getBytes(), library).mesh();
    }
}
