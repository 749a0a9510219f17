package org.jsmesh.files.gltf;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import org.jsmesh.mesh.Note;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Losses that are seen are warnings. */
class GltfWarningsTest {
    private static final String TARGETS = "{\"attributes\":{\"POSITION\":0},\"targets\":[{\"POSITION\":0}]}";

    @ParameterizedTest
    @ValueSource(strings = {"{\"mesh\":0,\"weights\":[0.5]}", "{\"mesh\":0,\"weights\":[0,null,1]}"})
    void shouldWarnOfMorphsThatShapeWhatIsShown(String node) throws IOException {
        GlbBuilder builder = GlbBuilder.triangle().primitive(TARGETS).nodes(node);
        assertThat(builder.read().notes())
                .containsExactly(Note.dropped("Morph targets dropped.", 1, "").asWarning());
    }

    @Test
    void shouldNotWarnOfMorphsWithoutWeight() throws IOException {
        GlbBuilder builder = GlbBuilder.triangle().primitive(TARGETS).nodes("{\"mesh\":0,\"weights\":[0]}");
        assertThat(builder.read().notes()).containsExactly(Note.dropped("Morph targets dropped.", 1, ""));
    }
}
