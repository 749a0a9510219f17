package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.jsmesh.mesh.MeshComparison;
import org.jsmesh.test.SampleModels;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Reads every sample model and writes it in its own format. */
class SampleModelsRoundTripTest {
    static List<Path> models() {
        return SampleModels.all().stream()
                .filter(file -> ModelFormat.ofName(file.toString()) != ModelFormat.GLB)
                .toList();
    }

    @ParameterizedTest
    @MethodSource("models")
    void shouldComeBackFromItsOwnFormat(Path file) throws IOException {
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
