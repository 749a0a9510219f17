package org.jsmesh.app.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.ForkJoinPool;
import javax.imageio.ImageIO;
import org.jsmesh.archive.Provenance;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.Texture;
import org.junit.jupiter.api.Test;

class ShownByPrefixTest {
    private static final int IMAGES = 5;
    private static final int SIDE = 10; // quads of a sheet

    /** Each sheet has an image of noise, so that every missing one shows. */
    @Test
    void shouldCountEveryImageThatIsMissing() throws IOException {
        byte[] bytes = new MeshEncoder(EncoderSettings.defaults().withBaseFaces(20), ForkJoinPool.commonPool())
                .encode(sheets(), new Provenance("OBJ", List.of()), List.of(), ProgressListener.NONE)
                .bytes();
        ShownByPrefix.Result result = new ShownByPrefix(ArchiveFile.of(bytes), ProgressListener.NONE).measure();
        assertThat(result.rows()).anyMatch(row -> row.images() > 0 && row.images() < IMAGES);
        ShownByPrefix.Row before = result.rows().get(0);
        for (ShownByPrefix.Row row : result.rows()) {
            if (row.images() > before.images())
                assertThat(row.difference().colour())
                        .isLessThan(before.difference().colour());
            before = row;
            double missing = (double) (IMAGES - row.images()) / IMAGES;
            // Grey in place of noise is off by more than a quarter of white. Some sheets are seen less than others.
            assertThat(row.difference().colour())
                    .as("off with " + row.images() + " images after " + row.bytes() + " of " + bytes.length)
                    .isBetween(25 * missing, missing == 0 ? .5 : 50.5 - 5 * row.images());
        }
        assertThat(result.bytesOfColours()).isGreaterThan(bytes.length * 4L / 5);
    }

    private static Mesh sheets() throws IOException {
        float[] positions = new float[3 * IMAGES * (SIDE + 1) * (SIDE + 1)];
        int[] uv = new int[positions.length / 3 * 2];
        int[] faces = new int[6 * IMAGES * SIDE * SIDE];
        int[] faceMaterials = new int[faces.length / 3];
        List<Material> materials = new ArrayList<>();
        List<Texture> textures = new ArrayList<>();
        Random random = new Random(3);
        int vertex = 0;
        int corner = 0;
        for (int i = 0; i < IMAGES; i++) {
            String path = i + ".png";
            materials.add(new Material(
                    "m" + i,
                    List.of(new Material.Parameter("Kd", 1, 1, 1)),
                    List.of(new Material.TextureReference("map_Kd", path))));
            textures.add(new Texture(path, noise(random)));
            for (int y = 0; y <= SIDE; y++)
                for (int x = 0; x <= SIDE; x++, vertex++) {
                    positions[3 * vertex] = x + 2 * SIDE * i;
                    positions[3 * vertex + 1] = y;
                    uv[2 * vertex] = Float.floatToRawIntBits((float) x / SIDE);
                    uv[2 * vertex + 1] = Float.floatToRawIntBits((float) y / SIDE);
                    if (x == SIDE || y == SIDE) continue;
                    int[] quad = {vertex, vertex + 1, vertex + SIDE + 2, vertex, vertex + SIDE + 2, vertex + SIDE + 1};
                    faceMaterials[corner / 3] = i;
                    faceMaterials[corner / 3 + 1] = i;
                    for (int v : quad) faces[corner++] = v;
                }
        }
        Channel coordinates = new Channel(Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, uv, null);
        return new MeshBuilder()
                .positions(positions)
                .faceWedges(faces)
                .channels(List.of(coordinates))
                .materials(materials)
                .faceMaterials(faceMaterials)
                .textures(textures)
                .build();
    }

    private static byte[] noise(Random random) throws IOException {
        BufferedImage image = new BufferedImage(64, 64, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < 64; y++) for (int x = 0; x < 64; x++) image.setRGB(x, y, random.nextInt());
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageIO.write(image, "png", png);
        return png.toByteArray();
    }
}
