package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Files of next to nothing, and of nothing good: {@code encode} takes them as they are, or says why not. */
@Timeout(120)
class StrangeFilesTest {
    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "one triangle | v 0 0 0;v 1 0 0;v 0 1 0;f 1 2 3 | 1 faces",
                "two triangles | v 0 0 0;v 1 0 0;v 0 1 0;v 1 1 0;f 1 2 3;f 2 4 3 | 2 faces",
                "tetrahedron | v 0 0 0;v 1 0 0;v 0 1 0;v 0 0 1;f 1 3 2;f 1 2 4;f 2 3 4;f 3 1 4 | 4 faces",
                "no area | v 0 0 0;v 1 0 0;f 1 1 2;f 2 2 2 | 2 faces",
                "one point | v 5 5 5;v 5 5 5;v 5 5 5;f 1 2 3 | 1 faces",
                "enormous | v 3e38 0 0;v -3e38 1e38 0;v 0 3e38 -3e38;f 1 2 3 | 1 faces",
                "denormal | v 1e-45 0 0;v 0 3e-45 0;v 0 0 1e-42;f 1 2 3 | 1 faces",
            })
    void shouldEncodeWithoutLoss(String name, String lines, String said) throws IOException {
        Path model = Files.writeString(folder.resolve("strange.obj"), lines.replace(';', '\n') + '\n');
        checkEncoded(model, said);
    }

    @Test
    void shouldEncodeManyComponents() throws IOException {
        StringBuilder text = new StringBuilder();
        int n = 3000;
        for (int i = 0; i < n; i++) {
            String place = i % 60 + " " + i / 60;
            text.append("v ").append(place).append(" 0\nv ").append(place).append(" .5\nv 0 ");
            text.append(place).append("\nf -3 -2 -1\n");
        }
        checkEncoded(Files.writeString(folder.resolve("parts.obj"), text), n + " faces");
    }

    private void checkEncoded(Path model, String said) {
        Path archive = folder.resolve("strange.jsm");
        Cli cli = Cli.ok("encode", model, "-o", archive);
        assertThat(cli.out()).contains(said);
        assertThat(Cli.ok("verify", archive, model).out()).startsWith("identical");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "x.obj | v 0 0 0;v 1 0 0;v 0 1 0 | it is a point cloud of 3 points | Make a mesh of the points",
                "x.off | OFF;3 0 0;0 0 0;1 0 0;0 1 0 | it is a point cloud of 3 points | Make a mesh of the points",
                "x.obj | v 0 0 0;v nan 0 0;v 0 1 0;f 1 2 3 | x of vertex 2 is \"nan\" | Repair or remove this vertex",
                "x.off | OFF;3 1 0;0 0 0;inf 0 0;0 1 0;3 0 1 2 | x of vertex 1 is \"inf\" | Repair or remove this vertex",
                "x.obj | v 0 0 0;v 1e39 0 0;v 0 1 0;f 1 2 3 | x of vertex 2 is \"1e39\" | Scale the model down",
                "x.obj | v 0 0 0;v 1 0 0;v 0 1 0;f 1 2 4 | v number 4 | Repair or remove this face",
            })
    void shouldRefuseWithAReason(String name, String lines, String what, String remedy) throws IOException {
        Path model = Files.writeString(folder.resolve(name), lines.replace(';', '\n') + '\n');
        Path archive = folder.resolve("strange.jsm");
        Cli cli = Cli.run("encode", model, "-o", archive);
        assertThat(cli.code()).isEqualTo(1);
        assertThat(cli.err())
                .containsOnlyOnce("\n")
                .contains(name, what, remedy)
                .doesNotContain("fault in jSM")
                .doesNotContain("Exception");
        assertThat(archive).doesNotExist();
    }
}
