package org.jsmesh.samples;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.io.ModelFile;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The models in {@code models/} are what the generators here make, and what their README says of them. */
class SampleModelsTest {
    private static final Path MODELS = Path.of("..", "..", "models");

    @Tag("long")
    @Test
    void shouldMakeTheCommittedBytes() throws IOException {
        for (Map.Entry<String, byte[]> file : SampleModelMaker.make().entrySet()) {
            assertThat(Files.mismatch(MODELS.resolve(file.getKey()), temporary(file.getValue())))
                    .as("first difference of %s; models/README.md says how to make it anew", file.getKey())
                    .isEqualTo(-1);
        }
    }

    @Test
    void shouldBeSmallTogether() throws IOException {
        long bytes = 0;
        try (Stream<Path> files = Files.list(MODELS)) {
            for (Path file : files.toList()) bytes += Files.size(file);
        }
        assertThat(bytes).isLessThan(5_000_000);
    }

    @Test
    void shouldHaveASmoothOctopusInColour() throws IOException {
        Mesh octopus = read("octopus.ply");

        assertThat(octopus.faces()).isGreaterThan(60_000);
        assertThat(octopus.channel(Channel.Semantic.COLOUR).components()).isEqualTo(3);
        assertThat(octopus.bounds()[1]).isBetween(-0.1f, 0.1f);
        assertClosed(octopus);
        assertThat(volume(octopus)).isPositive();
    }

    @Test
    void shouldHaveAGearSetOfManyMaterialsAndCreases() throws IOException {
        Mesh gear = read("planetary-gear.obj");

        assertThat(gear.faces()).isBetween(20_000, 30_000);
        assertThat(gear.materials()).extracting(Material::name).hasSize(6).contains("brass", "black-oxide");
        assertThat(gear.wedges()).isGreaterThan(gear.vertices() + 10_000);
        assertThat(gear.channel(Channel.Semantic.NORMAL)).isNotNull();
        assertClosed(gear);
        assertThat(volume(gear)).isPositive();
    }

    @Test
    void shouldHaveATexturedAmphoraWithSeams() throws IOException {
        Mesh amphora = read("amphora.obj");

        assertThat(amphora.faces()).isBetween(10_000, 20_000);
        assertThat(amphora.channel(Channel.Semantic.TEXCOORD).components()).isEqualTo(2);
        assertThat(amphora.wedges()).isGreaterThan(amphora.vertices() + 100);
        assertThat(amphora.textures()).hasSize(1);
    }

    @Test
    void shouldPaintThePictureThatOthersRead() throws IOException {
        byte[] pixels = {0, 1, 2, 1, 0, 1, 2, 1, 0, 1, 2, 1, 2, 2, 2, 2, 2, 2, 2, 2};
        BufferedImage picture =
                ImageIO.read(temporary(PngBytes.write(5, 4, new int[] {0x102030, 0xffffff, 0xabcdef}, pixels))
                        .toFile());

        assertThat(picture.getRGB(0, 0)).isEqualTo(0xff102030);
        assertThat(picture.getRGB(1, 0)).isEqualTo(0xffffffff);
        assertThat(picture.getRGB(4, 3)).isEqualTo(0xffabcdef);
        BufferedImage painting = ImageIO.read(MODELS.resolve("amphora.png").toFile());
        assertThat(painting.getWidth()).isEqualTo(AmphoraPainting.WIDTH);
        assertThat(painting.getHeight()).isEqualTo(AmphoraPainting.HEIGHT);
    }

    private static Mesh read(String name) throws IOException {
        ModelFile file = ModelFiles.read(MODELS.resolve(name));
        assertThat(file.notes()).allMatch(note -> note.text().contains("names not kept"), "only names are lost");
        return file.mesh();
    }

    private static Path temporary(byte[] content) throws IOException {
        Path file = Files.createTempFile("sample", null);
        file.toFile().deleteOnExit();
        return Files.write(file, content);
    }

    /** Every edge has two faces, which run along it in opposite directions. */
    private static void assertClosed(Mesh mesh) {
        Map<Long, Integer> edges = new HashMap<>();
        for (int f = 0; f < mesh.faces(); f++) {
            for (int corner = 0; corner < 3; corner++) {
                long from = mesh.vertex(f, corner);
                long to = mesh.vertex(f, (corner + 1) % 3);
                edges.merge(from << 32 | to, 1, Integer::sum);
            }
        }
        edges.forEach((edge, count) -> {
            assertThat(count).as("faces along the half-edge %d", edge).isEqualTo(1);
            assertThat(edges.containsKey(edge << 32 | edge >>> 32))
                    .as("the other half of the edge %d", edge)
                    .isTrue();
        });
    }

    private static double volume(Mesh mesh) {
        double sixfold = 0;
        float[] p = mesh.positions();
        for (int f = 0; f < mesh.faces(); f++) {
            int a = 3 * mesh.vertex(f, 0);
            int b = 3 * mesh.vertex(f, 1);
            int c = 3 * mesh.vertex(f, 2);
            sixfold += p[a] * (p[b + 1] * p[c + 2] - p[b + 2] * p[c + 1])
                    + p[a + 1] * (p[b + 2] * p[c] - p[b] * p[c + 2])
                    + p[a + 2] * (p[b] * p[c + 1] - p[b + 1] * p[c]);
        }
        return sixfold / 6;
    }
}
