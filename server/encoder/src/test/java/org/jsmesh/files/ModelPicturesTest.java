package org.jsmesh.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.Texture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ModelPicturesTest {
    @ParameterizedTest
    @ValueSource(strings = {"png", "jpg", "bmp", "gif"})
    void shouldReadWhatViewersShow(String kind) throws Exception {
        List<Picture> pictures = ModelPictures.of(model(new Texture("a." + kind, image(kind, 60, 40))));
        assertThat(pictures).hasSize(1);
        Picture p = pictures.get(0);
        assertThat(p.path()).isEqualTo("a." + kind);
        assertThat(p.width()).isEqualTo(60);
        assertThat(p.height()).isEqualTo(40);
        assertThat(p.rgb()[5] >> 16 & 255).isGreaterThan(240); // red above
        assertThat(p.rgb()[60 * 39 + 5] & 255).isGreaterThan(240); // blue below
    }

    @ParameterizedTest
    @CsvSource({"600, 400, false", "101, 75, false", "600, 400, true", "8, 8, true"})
    void shouldReadTheMeansOfProgressiveJpegs(int width, int height, boolean grey) throws Exception {
        BufferedImage image =
                new BufferedImage(width, height, grey ? BufferedImage.TYPE_BYTE_GRAY : BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < height; y++)
            for (int x = 0; x < width; x++) {
                int level = 40 + 170 * x / width;
                image.getRaster().setSample(x, y, 0, level);
                if (grey) continue;
                image.getRaster().setSample(x, y, 1, 40 + 170 * y / height);
                image.getRaster().setSample(x, y, 2, 90);
            }
        Picture p = ModelPictures.of(model(new Texture("a.jpg", progressive(image))))
                .get(0);
        assertThat(p.width()).isEqualTo((width + 7) / 8);
        assertThat(p.height()).isEqualTo((height + 7) / 8);
        for (int row = 0; row < height / 8; row++)
            for (int column = 0; column < width / 8; column++)
                for (int k = 0; k < 3; k++) {
                    int sum = 0;
                    for (int i = 0; i < 64; i++)
                        sum += image.getRaster().getSample(8 * column + i % 8, 8 * row + i / 8, grey ? 0 : k);
                    assertThat(p.rgb()[row * p.width() + column] >> 16 - 8 * k & 255)
                            .isCloseTo(sum / 64, within(width < 200 ? 24 : 10)); // colours are coarser
                }
    }

    @Test
    void shouldPassOverDamagedProgressiveJpegs() throws Exception {
        byte[] good = progressive(new BufferedImage(90, 70, BufferedImage.TYPE_INT_RGB));
        Random random = new Random(11);
        for (int i = 0; i < 3000; i++) {
            byte[] bad = Arrays.copyOf(good, random.nextBoolean() ? good.length : random.nextInt(good.length));
            for (int k = random.nextInt(4); k >= 0 && bad.length > 0; k--)
                bad[random.nextInt(bad.length)] = (byte) random.nextInt(256);
            assertThat(ModelPictures.of(model(new Texture("a.jpg", bad)))).hasSizeLessThan(2);
        }
    }

    private static byte[] progressive(BufferedImage image) throws Exception {
        ImageWriter writer = ImageIO.getImageWritersByFormatName("jpeg").next();
        ImageWriteParam how = writer.getDefaultWriteParam();
        how.setProgressiveMode(ImageWriteParam.MODE_DEFAULT);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (ImageOutputStream stream = ImageIO.createImageOutputStream(out)) {
            writer.setOutput(stream);
            writer.write(null, new IIOImage(image, null, null), how);
        }
        writer.dispose();
        return out.toByteArray();
    }

    @Test
    void shouldMakeLargeImagesSmaller() throws Exception {
        Picture p = ModelPictures.of(model(new Texture("a.png", image("png", 1300, 700))))
                .get(0);
        assertThat(p.width()).isEqualTo(434); // a third, the last pixel from one column
        assertThat(p.height()).isEqualTo(234);
        assertThat(p.rgb()[0]).isEqualTo(0xff0000);
        assertThat(p.rgb()[p.rgb().length - 1]).isEqualTo(0x0000ff);
    }

    @Test
    void shouldPassOverWhatItCannotReadAndWhatNobodySees() throws Exception {
        byte[] good = image("png", 8, 8);
        byte[] cut = Arrays.copyOf(good, good.length / 2);
        byte[] noise = new byte[1000];
        new Random(4).nextBytes(noise);
        Mesh mesh = model(
                new Texture("cut.png", cut), new Texture("noise.jpg", noise), new Texture("none.png", new byte[0]));
        assertThat(ModelPictures.of(mesh)).isEmpty();
        Mesh bumps = MeshBuilder.from(model(new Texture("a.png", good)))
                .materials(List.of(
                        new Material("m", List.of(), List.of(new Material.TextureReference("map_bump", "a.png")))))
                .build();
        assertThat(ModelPictures.of(bumps)).isEmpty();
    }

    @Test
    void shouldPassOverImagesThatClaimToBeHuge() throws Exception {
        byte[] file = image("bmp", 8, 8);
        file[18 + 2] = file[22 + 2] = 2; // more than 131,000 columns and rows
        assertThat(ModelPictures.of(model(new Texture("a.bmp", file)))).isEmpty();
    }

    /** Red above, blue below. */
    private static byte[] image(String kind, int width, int height) throws Exception {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < height; y++)
            for (int x = 0; x < width; x++) image.setRGB(x, y, 2 * y < height ? 0xff0000 : 0x0000ff);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        assertThat(ImageIO.write(image, kind, out)).isTrue();
        return out.toByteArray();
    }

    private static Mesh model(Texture... textures) {
        List<Material> materials = new ArrayList<>();
        for (Texture t : textures)
            materials.add(
                    new Material(t.path(), List.of(), List.of(new Material.TextureReference("map_Kd", t.path()))));
        return new MeshBuilder()
                .positions(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0})
                .faceWedges(new int[] {0, 1, 2})
                .materials(materials)
                .textures(List.of(textures))
                .build();
    }
}
