package org.jsmesh.app.paper;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.test.SampleModels;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The text holds all that a client needs: the original is made again from it alone. */
class PaperFormatTest {
    @Test
    void shouldBringATorusBack() {
        Mesh torus = StandIn.torus(1200);
        PaperFormat.Streaming streaming = PaperFormat.of(torus, Levels.USUAL);
        assertThat(streaming.patches()).hasSize(torus.vertices() - streaming.vertices());
        assertThat(streaming.faces()).isLessThan(torus.faces());
        assertThat(new Reader(streaming.base(), false)
                        .apply(streaming.patches())
                        .faces())
                .isEqualTo(new Reader(PaperFormat.original(torus), false).faces());
    }

    @ParameterizedTest
    @ValueSource(strings = {"octopus.ply", "amphora.obj"})
    void shouldBringAttributesBack(String name) throws Exception {
        Mesh mesh = Reduction.clean(
                ModelFiles.read(SampleModels.project().resolve("models").resolve(name))
                        .mesh());
        PaperFormat.Streaming streaming = PaperFormat.of(mesh, Levels.USUAL);
        assertThat(streaming.patches()).isNotEmpty();
        assertThat(new Reader(streaming.base(), true).apply(streaming.patches()).faces())
                .isEqualTo(new Reader(PaperFormat.original(mesh), true).faces());
    }

    /** Reads the text as its description has it. */
    private static final class Reader {
        private final ClientMesh mesh = new ClientMesh();
        private final List<String> positions = new ArrayList<>();
        private final List<String> attributes = new ArrayList<>(); // of wedges
        private final boolean hasAttributes;

        Reader(String text, boolean hasAttributes) {
            this.hasAttributes = hasAttributes;
            String[] lines = text.split("\n");
            int[] counts = numbers(lines[0], 0);
            int at = 1;
            for (int i = 0; i < counts[0]; i++) positions.add(lines[at++]);
            int[] vertexOf = new int[counts[1]];
            for (int i = 0; i < counts[1]; i++) {
                if (!hasAttributes) {
                    vertexOf[i] = i;
                    attributes.add("");
                    continue;
                }
                String[] words = lines[at++].split(" ", 2);
                vertexOf[i] = Integer.parseInt(words[0]);
                attributes.add(words[1]);
            }
            for (int i = 0; i < counts[2]; i++) {
                int[] face = numbers(lines[at++], 0);
                int[] corners = {vertexOf[face[0]], vertexOf[face[1]], vertexOf[face[2]]};
                mesh.add(corners, Arrays.copyOf(face, 3), face.length > 3 ? face[3] : -1);
            }
            assertThat(at).isEqualTo(lines.length);
        }

        Reader apply(List<String> patches) {
            for (String patch : patches) {
                String[] words = patch.strip().split(" ");
                positions.add(String.join(" ", Arrays.copyOf(words, 3)));
                attributes.add(String.join(" ", Arrays.copyOfRange(words, 3, words.length - 3)));
                int[] place = numbers(patch.strip(), words.length - 3);
                mesh.split(place[0], place[1], place[2], positions.size() - 1, attributes.size() - 1);
            }
            return this;
        }

        private static int[] numbers(String line, int from) {
            return Arrays.stream(line.split(" "))
                    .skip(from)
                    .mapToInt(Integer::parseInt)
                    .toArray();
        }

        /** Each face by what its corners have, from the least one on; sorted. */
        List<String> faces() {
            List<String> faces = new ArrayList<>();
            for (int f = 0; f < mesh.faces(); f++) {
                String[] corners = new String[3];
                for (int k = 0; k < 3; k++)
                    corners[k] = positions.get(mesh.vertex(f, k))
                            + (hasAttributes ? "; " + attributes.get(mesh.wedge(f, k)) : "");
                int least = 0;
                for (int k = 1; k < 3; k++) if (corners[k].compareTo(corners[least]) < 0) least = k;
                faces.add(corners[least] + " | " + corners[(least + 1) % 3] + " | " + corners[(least + 2) % 3] + " | "
                        + mesh.material(f));
            }
            faces.sort(null);
            return faces;
        }
    }
}
