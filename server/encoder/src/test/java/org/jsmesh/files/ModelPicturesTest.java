package org.jsmesh.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.zip.CRC32;
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
        assertThat(p.argb()[5] >> 16 & 255).isGreaterThan(240); // red above
        assertThat(p.argb()[60 * 39 + 5] & 255).isGreaterThan(240); // blue below
    }

    @Test
    void shouldReadTga() {
        byte[] tga = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 1, 0, 24, 0x20, 0, 0, -1, -1, 0, 0};
        Picture picture = ModelPictures.of(model(new Texture("a.tga", tga))).get(0);
        assertThat(picture.argb()).containsExactly(0xffff0000, 0xff0000ff);
    }

    @ParameterizedTest
    @CsvSource({"600, 400, false", "101, 75, false", "600, 400, true", "8, 8, true"})
    void shouldReadProgressiveJpegs(int width, int height, boolean grey) throws Exception {
        BufferedImage image = waves(width, height, grey);
        byte[] file = progressive(image);
        Picture p = ModelPictures.of(model(new Texture("a.jpg", file))).get(0);
        assertThat(p.width()).isEqualTo(width);
        assertThat(p.height()).isEqualTo(height);
        BufferedImage right = ImageIO.read(new ByteArrayInputStream(file));
        long off = 0;
        for (int i = 0; i < width * height; i++)
            for (int k = 0; k < 3; k++)
                off += Math.abs((p.argb()[i] >> 16 - 8 * k & 255)
                        - right.getRaster().getSample(i % width, i / width, grey ? 0 : k));
        // Where colours have fewer pixels, that reader mixes them across pixels.
        assertThat((double) off / (3 * width * height)).isLessThan(grey ? .1 : 1);
    }

    /** Waves of growing frequency, with edges. */
    private static BufferedImage waves(int width, int height, boolean grey) {
        BufferedImage image =
                new BufferedImage(width, height, grey ? BufferedImage.TYPE_BYTE_GRAY : BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < height; y++)
            for (int x = 0; x < width; x++)
                for (int k = 0; k < image.getRaster().getNumBands(); k++) {
                    int level = (int) (127 + 90 * Math.sin(x * x * .002 + y * .1)) ^ (x / 40 + y / 40 & 1) * 31;
                    image.getRaster().setSample(x, y, k, level - 10 * k);
                }
        return image;
    }

    @Test
    void shouldReadOfVeryLargeProgressiveJpegsTheMeans() throws Exception {
        int width = 8400;
        int height = 8000;
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_BYTE_GRAY);
        for (int i = 0; i < width * height; i += 1)
            image.getRaster().getDataBuffer().setElem(i, 40 + 170 * (i % width) / width);
        Picture p = ModelPictures.of(model(new Texture("a.jpg", progressive(image))))
                .get(0);
        assertThat(p.width()).isEqualTo(width / 8);
        assertThat(p.height()).isEqualTo(height / 8);
        for (int x = 0; x < p.width(); x += 50)
            assertThat(p.argb()[500 * p.width() + x] & 255).isCloseTo(40 + 170 * x / p.width(), within(3));
    }

    @Test
    void shouldShowTheNumbersOfAPngWhateverItsColourSpace() throws Exception {
        byte[] gamma = {0, 0, 0, 4, 'g', 'A', 'M', 'A', 0, 1, (byte) 0x86, (byte) 0xa0, 0, 0, 0, 0}; // 1.0
        CRC32 crc = new CRC32();
        crc.update(gamma, 4, 8);
        for (int i = 0; i < 4; i++) gamma[12 + i] = (byte) (crc.getValue() >> 24 - 8 * i);
        BufferedImage grey = new BufferedImage(4, 4, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 16; i++) grey.setRGB(i % 4, i / 4, 0x808080);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        assertThat(ImageIO.write(grey, "png", out)).isTrue();
        byte[] plain = out.toByteArray();
        int head = 8 + 25;
        byte[] file = Arrays.copyOf(plain, plain.length + gamma.length);
        System.arraycopy(gamma, 0, file, head, gamma.length);
        System.arraycopy(plain, head, file, head + gamma.length, plain.length - head);
        Picture p = ModelPictures.of(model(new Texture("a.png", file))).get(0);
        assertThat(p.argb()[5]).isEqualTo(0xff808080);
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
        Picture p = ModelPictures.of(model(new Texture("a.png", image("png", 5200, 2800))))
                .get(0);
        assertThat(p.width()).isEqualTo(1734); // a third, the last pixel from one column
        assertThat(p.height()).isEqualTo(934);
        assertThat(p.argb()[0]).isEqualTo(0xffff0000);
        assertThat(p.argb()[p.argb().length - 1]).isEqualTo(0xff0000ff);
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
        Mesh other = MeshBuilder.from(model(new Texture("a.png", good)))
                .materials(
                        List.of(new Material("m", List.of(), List.of(new Material.TextureReference("refl", "a.png")))))
                .build();
        assertThat(ModelPictures.of(other)).isEmpty();
    }

    @Test
    void shouldReadWhatOtherSlotsShowToo() throws Exception {
        Mesh bumps = MeshBuilder.from(model(new Texture("a.png", image("png", 8, 8))))
                .materials(List.of(
                        new Material("m", List.of(), List.of(new Material.TextureReference("map_bump", "a.png")))))
                .build();
        assertThat(ModelPictures.of(bumps)).hasSize(1);
    }

    @Test
    void shouldReadAnImageOfSeveralPathsOnce() throws Exception {
        byte[] file = image("png", 8, 8);
        List<Picture> pictures =
                ModelPictures.of(model(new Texture("a.png", file), new Texture("b.png", file.clone())));
        assertThat(pictures).extracting(Picture::path).containsExactly("a.png");
    }

    @Test
    void shouldCountColoursByTheirOpacity() throws Exception {
        BufferedImage image = new BufferedImage(3000, 2, BufferedImage.TYPE_INT_ARGB);
        for (int x = 0; x < 3000; x++)
            for (int y = 0; y < 2; y++) image.setRGB(x, y, x % 2 == 0 ? 0xffff0000 : 0x0000ff00);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ImageIO.write(image, "png", out);
        Picture p =
                ModelPictures.of(model(new Texture("a.png", out.toByteArray()))).get(0);
        assertThat(p.width()).isEqualTo(1500);
        assertThat(p.argb()[3] >>> 24).isEqualTo(128);
        assertThat(p.argb()[3] >> 16 & 255).isGreaterThan(250);
        assertThat(p.argb()[3] >> 8 & 255).isLessThan(5);
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
