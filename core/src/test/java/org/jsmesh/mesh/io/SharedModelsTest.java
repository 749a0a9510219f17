package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.jsmesh.mesh.MeshComparison;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/** Reads the real models beside the repository, where they are, and writes them in their own formats. */
class SharedModelsTest {
    @TestFactory
    List<DynamicTest> shouldReadAndWriteEveryModel() throws IOException {
        Path folder = folder();
        assumeTrue(folder != null, "no folder ../shared/models: real models are not tested");
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(f -> ModelFormat.ofName(f.toString()) != null
                            && ModelFormat.ofName(f.toString()) != ModelFormat.GLB)
                    .sorted()
                    .map(f -> DynamicTest.dynamicTest(folder.relativize(f).toString(), () -> shouldComeBack(f)))
                    .toList();
        }
    }

    private static Path folder() {
        for (Path at = Path.of("").toAbsolutePath(); at != null; at = at.getParent()) {
            Path models = at.resolve("shared/models");
            if (Files.isDirectory(models)) return models;
        }
        return null;
    }

    private static void shouldComeBack(Path file) throws IOException {
        String name = file.getFileName().toString();
        ResourceResolver beside = path -> {
            Path resource = file.resolveSibling(path);
            return Files.isRegularFile(resource) ? Optional.of(Files.readAllBytes(resource)) : Optional.empty();
        };
        ModelFile original = ModelReader.read(name, Files.readAllBytes(file), beside);
        assertThat(original.format()).isEqualTo(ModelFormat.ofName(name));
        assertThat(original.mesh().faces()).isPositive();
        MemoryFiles written = new MemoryFiles();
        assertThat(ModelWriter.write(original.mesh(), original.format(), name, written))
                .isEmpty();
        assertThat(MeshComparison.firstDifference(
                        original.mesh(), written.read(name).mesh()))
                .isEmpty();
    }
}
