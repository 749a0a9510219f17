package org.jsmesh.desktop.dialog;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SwingDialogsTest {
    @ParameterizedTest
    @CsvSource({
        "a.obj, .obj, false, true, a.obj",
        "a.OBJ, .obj, true, true, a.OBJ",
        "a.ply, .obj, false, true, a.ply",
        "a.obj, .ply, true, true, a.ply",
        "a, .obj, false, true, a.obj",
        "v1.2, .glb, false, true, v1.2.glb",
        "a.3mf, .obj, false, true, a.3mf.obj",
        "a.ply.gz, .obj, false, true, a.ply.gz.obj",
        "a.obj, .png, false, false, a.obj.png"
    })
    void shouldBringNameAndFormatTogether(
            String typed, String extension, boolean isChosen, boolean isModel, String name) {
        Path folder = Path.of("models");
        assertThat(SwingDialogs.named(folder.resolve(typed), extension, isChosen, isModel))
                .isEqualTo(folder.resolve(name));
    }
}
