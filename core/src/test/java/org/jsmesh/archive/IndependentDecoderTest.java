package org.jsmesh.archive;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.test.RandomMeshes;
import org.jsmesh.test.Requirement;
import org.jsmesh.test.SampleModels;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * What docs/format.md says is what archives are: a decoder that was written along it, in another language, finds the
 * mesh that was encoded.
 */
class IndependentDecoderTest {
    private static final int SEEDS = 4;

    @TempDir
    Path folder;

    private final Map<Path, String> expected = new LinkedHashMap<>();

    @Test
    void shouldFindTheMesh() throws Exception {
        Path python = Requirement.python();
        for (RandomMeshes kind : RandomMeshes.values()) {
            for (int seed = 21; seed < 21 + SEEDS; seed++) add(kind + "-" + seed, kind.mesh(seed));
        }
        assertThat(decode(python)).isEqualTo(lines());
    }

    private void add(String name, Mesh mesh) throws Exception {
        Path file = folder.resolve(name + ".jsm");
        Files.write(file, TestArchives.encodeFar(mesh).bytes());
        expected.put(file, MeshIdentity.sha256(mesh));
    }

    private List<String> lines() {
        List<String> lines = new ArrayList<>();
        expected.forEach((file, hash) -> lines.add(hash + " " + file));
        return lines;
    }

    /** What the decoder prints: a line for each file. */
    private List<String> decode(Path python) throws Exception {
        List<String> command = new ArrayList<>();
        command.add(python.toString());
        command.add("-B"); // leaves no compiled files beside the sources
        command.add(SampleModels.project()
                .resolve("core/src/test/python/jsm_decode.py")
                .toString());
        for (Path file : expected.keySet()) command.add(file.toString());
        Path out = folder.resolve("out.txt");
        Process process = new ProcessBuilder(command)
                .redirectErrorStream(true)
                .redirectOutput(out.toFile())
                .start();
        try {
            assertThat(process.waitFor(5, TimeUnit.MINUTES))
                    .as("the decoder ends")
                    .isTrue();
        } finally {
            process.destroyForcibly();
        }
        return Files.readAllLines(out);
    }
}
