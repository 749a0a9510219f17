package org.jsmesh.desktop.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import org.jsmesh.desktop.draw.Shapes;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.io.ModelFormat;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ModelImportTest {
    @TempDir
    private Path folder;

    @Test
    void shouldMakeAnArchiveThatGoesAgain() throws IOException {
        Mesh mesh = Shapes.torus(12, 8);
        Path model = folder.resolve("torus.ply");
        ModelFiles.write(mesh, model, ModelFormat.PLY);
        ModelImport made = ModelImport.of(model, ProgressListener.NONE);
        assertThat(MeshIdentity.sha256(ArchiveFile.read(made.archive()).original(ProgressListener.NONE)))
                .isEqualTo(MeshIdentity.sha256(ModelFiles.read(model).mesh()));
        made.close();
        assertThat(made.archive()).doesNotExist();
        assertThat(made.archive().getParent()).doesNotExist();
    }

    @Test
    void shouldLeaveNothingBehindWhenItFailsOrIsStopped() throws IOException {
        Path place = Files.createDirectory(folder.resolve("place"));
        assertThatThrownBy(() -> ModelImport.of(folder.resolve("none.ply"), place, ProgressListener.NONE))
                .isInstanceOf(NoSuchFileException.class);
        Path model = folder.resolve("torus.ply");
        ModelFiles.write(Shapes.torus(12, 8), model, ModelFormat.PLY);
        ProgressListener impatient = new ProgressListener() {
            @Override
            public void progress(String stage, double fraction) {}

            @Override
            public boolean isCancelled() {
                return true;
            }
        };
        assertThatThrownBy(() -> ModelImport.of(model, place, impatient)).isInstanceOf(CancellationException.class);
        assertThat(place).isEmptyDirectory();
    }
}
