package org.jsmesh.desktop.draw;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.jsmesh.display.DisplaySlots;
import org.jsmesh.display.Raster;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.Texture;
import org.junit.jupiter.api.Test;

class TextureImagesTest {
    private final TextureImages images = new TextureImages();

    @Test
    void shouldShowAPreviewUntilTheImageIsThere() {
        Picture small = new Picture("a.png", 1, 1, new int[] {0xff102030});
        Picture larger = new Picture("a.png", 2, 1, new int[] {0xff102030, 0xff405060});
        TextureImage first = images.of(previewing(small)).get("a.png");
        assertThat(first.argb()).containsExactly(0xff102030);
        TextureImage second = images.of(previewing(larger)).get("a.png");
        assertThat(second.argb()).containsExactly(0xff102030, 0xff405060);
        Raster image = new Raster(3, 1, new int[] {1, 2, 3});
        Mesh arrived = new MeshBuilder()
                .textures(List.of(new Texture("a.png", image.png())))
                .build();
        assertThat(images.of(arrived).get("a.png").width()).isEqualTo(3);
        assertThat(images.problem()).isNull();
    }

    @Test
    void shouldGiveTheSameImageAgainSoThatItIsUploadedOnce() {
        Map<String, TextureImage> before = images.of(previewing(new Picture("a.png", 1, 1, new int[] {7})));
        Map<String, TextureImage> after = images.of(previewing(new Picture("a.png", 1, 1, new int[] {7})));
        assertThat(after.get("a.png")).isSameAs(before.get("a.png"));
    }

    @Test
    void shouldDecodeTga() {
        byte[] tga = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 1, 0, 24, 0x20, 0, 0, -1, -1, 0, 0};
        Mesh mesh =
                new MeshBuilder().textures(List.of(new Texture("a.tga", tga))).build();
        assertThat(images.of(mesh).get("a.tga").argb()).containsExactly(0xffff0000, 0xff0000ff);
        assertThat(images.problem()).isNull();
    }

    @Test
    void shouldMakeMasksOfImagesThatHaveArrivedAndNotOfPreviews() {
        Material holes = new Material("m", List.of(), List.of(new Material.TextureReference("map_d", "a.png")));
        DisplaySlots slots = DisplaySlots.of(List.of(holes), false);
        Picture picture = new Picture("a.png", 1, 1, new int[] {0xffffffff});
        images.of(previewing(picture));
        assertThat(images.masks(slots)).isEmpty();
        images.of(new MeshBuilder()
                .textures(List.of(new Texture("a.png", new Raster(1, 1, picture.argb()).png())))
                .build());
        assertThat(images.masks(slots).get("a.png").argb()).containsExactly(0xff000000);
    }

    /** Java's own conversion of grey images would make 128 a 188. */
    @Test
    void shouldKeepShadesOfGrey() throws IOException {
        for (String format : new String[] {"png", "jpg"}) {
            BufferedImage grey = new BufferedImage(8, 8, BufferedImage.TYPE_BYTE_GRAY);
            for (int i = 0; i < 64; i++) grey.getRaster().setSample(i % 8, i / 8, 0, 128);
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            ImageIO.write(grey, format, out);
            Mesh mesh = new MeshBuilder()
                    .textures(List.of(new Texture("a." + format, out.toByteArray())))
                    .build();
            assertThat(images.of(mesh).get("a." + format).argb()).containsOnly(0xff808080);
        }
    }

    @Test
    void shouldTellOfAnImageThatJavaCannotRead() {
        byte[] webp = "RIFF....WEBPVP8 ".getBytes(StandardCharsets.US_ASCII);
        Mesh mesh =
                new MeshBuilder().textures(List.of(new Texture("a.webp", webp))).build();
        assertThat(images.of(mesh)).isEmpty();
        assertThat(images.problem())
                .isEqualTo("The texture a.webp cannot be shown: it is not a PNG, JPEG, GIF, BMP, TIFF or TGA image");
    }

    private static Mesh previewing(Picture picture) {
        return new MeshBuilder().previews(List.of(picture)).build();
    }
}
