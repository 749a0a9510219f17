package org.jsmesh.collapse;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.lifecycle.AddLifecycleHook;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshCleaner;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.VertexMerger;
import org.jsmesh.mesh.io.ModelReader;
import org.jsmesh.test.FewerTries;
import org.jsmesh.test.RandomMeshes;
import org.jsmesh.test.SampleModels;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every mesh between the original and the base is valid, whichever simplifier made it. */
@AddLifecycleHook(FewerTries.class)
class ValidCollapsesTest {
    /** Larger files take too long. */
    private static final long MOST_BYTES = 3_000_000;

    private static final double QUADRIC_COSINE = 0.2;
    private static final double PAPER_COSINE = 0;
    private static final List<Double> THRESHOLDS = List.of(0.1, 0.5, 10.0);

    @Property(tries = 300, seed = "1")
    void shouldKeepRandomMeshesValidWithEveryCollapse(
            @ForAll RandomMeshes kind, @ForAll long seed, @ForAll Effort effort) {
        Mesh mesh = kind.mesh(seed);
        new CollapseReplay(quadric(mesh, effort), QUADRIC_COSINE).run(true);
    }

    @Property(tries = 300, seed = "1")
    void shouldKeepRandomMeshesValidWithEveryCollapseOfThePaper(@ForAll RandomMeshes kind, @ForAll long seed) {
        Mesh mesh = kind.mesh(seed);
        new CollapseReplay(paper(mesh), PAPER_COSINE).run(true);
    }

    @Tag("long")
    @ParameterizedTest
    @MethodSource("models")
    void shouldKeepModelsValidWithEveryPass(Path file) throws IOException {
        Mesh mesh = read(file);
        for (Effort effort : Effort.values()) {
            CollapseMesh quadric = quadric(mesh, effort);
            if (mesh.faces() > 500) assertThat(quadric.log().size()).isPositive();
            new CollapseReplay(quadric, QUADRIC_COSINE).run(false);
        }
        new CollapseReplay(paper(mesh), PAPER_COSINE).run(false);
    }

    static List<Path> models() {
        return SampleModels.all().stream()
                .filter(file ->
                        !file.toString().endsWith(".glb") && file.toFile().length() < MOST_BYTES)
                .toList();
    }

    private static CollapseMesh quadric(Mesh mesh, Effort effort) {
        CollapseMesh simplified = new CollapseMesh(mesh);
        QuadricSimplifier.simplify(simplified, SimplificationTarget.floor(), effort, ProgressListener.NONE);
        return simplified;
    }

    private static CollapseMesh paper(Mesh mesh) {
        CollapseMesh simplified = new CollapseMesh(mesh);
        PaperSimplifier.simplify(simplified, THRESHOLDS, SimplificationTarget.floor(), ProgressListener.NONE);
        return simplified;
    }

    private static Mesh read(Path file) throws IOException {
        Mesh mesh = ModelReader.read(file.getFileName().toString(), Files.readAllBytes(file), path -> Optional.empty())
                .mesh();
        List<Note> notes = new ArrayList<>();
        return VertexMerger.merge(MeshCleaner.clean(mesh, notes), notes);
    }
}
