package org.jsmesh.encoder;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import javax.imageio.ImageIO;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.Texture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
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
