package org.jsmesh.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.io.Resource;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ModelInputsTest {
    private static final String CUBE = "mtllib Parts/Wood.MTL\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
            + "usemtl wood\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n";

    @TempDir
    Path folder;

    private ModelInputs encoded() throws IOException {
        ModelInputs inputs = new ModelInputs();
        new ModelEncoding(EncoderSettings.defaults()).encode(folder.resolve("cube.obj"), inputs, ProgressListener.NONE);
        return inputs;
    }

    @Test
    void shouldTellEveryFileThatAnEncodingReads() throws Exception {
        Files.writeString(folder.resolve("cube.obj"), CUBE);
        Path parts = Files.createDirectory(folder.resolve("parts"));
        Files.writeString(parts.resolve("wood.mtl"), "newmtl wood\nmap_Kd bark.png\n");
        ModelInputs inputs = encoded();
        assertThat(inputs.toJson())
                .contains("\"asked\":\"Parts/Wood.MTL\",\"found\":\"parts/wood.mtl\"")
                .contains("bark.png");
        assertThat(inputs.areFoundBy(new FolderResources(folder))).isTrue();
        assertThat(inputs.witnesses(folder.resolve("cube.obj")))
                .contains(parts.resolve("wood.mtl"), folder, parts)
                .doesNotContain(folder.resolve("cube.obj"));
        Files.writeString(parts.resolve("bark.png"), "the picture that was missing");
        assertThat(inputs.areFoundBy(new FolderResources(folder))).isFalse();
    }

    @Test
    void shouldComeBackFromItsText() throws Exception {
        Files.writeString(folder.resolve("cube.obj"), CUBE);
        ModelInputs inputs = encoded();
        ModelInputs back = ModelInputs.fromJson(inputs.toJson());
        assertThat(back).isEqualTo(inputs).hasSameHashCodeAs(inputs);
        assertThat(back.modelSha256()).isEqualTo(inputs.modelSha256()).hasSize(64);
        assertThat(back.areFoundBy(new FolderResources(folder))).isTrue();
        Files.writeString(
                Files.createDirectory(folder.resolve("parts")).resolve("wood.mtl"), "the one that was missing");
        assertThat(back.areFoundBy(new FolderResources(folder))).isFalse();
        assertThatThrownBy(() -> ModelInputs.fromJson("{")).isInstanceOf(IOException.class);
    }

    @Test
    void shouldDisownWhatChangedWhileItWasRead() throws Exception {
        ModelInputs inputs = new ModelInputs();
        inputs.model(new byte[] {1});
        byte[] content = {1};
        var resources = inputs.noting(path -> Optional.of(content.clone()));
        resources.find("a");
        assertThat(resources.locate("a").map(Resource::path)).contains("a");
        assertThat(inputs.modelSha256()).isNotNull();
        content[0] = 2;
        resources.find("a");
        assertThat(inputs.modelSha256()).isNull();
    }
}
