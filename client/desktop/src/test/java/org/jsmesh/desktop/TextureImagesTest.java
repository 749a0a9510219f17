package org.jsmesh.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.Texture;
import org.junit.jupiter.api.Test;

class TextureImagesTest {
    private final TextureImages images = new TextureImages();

    @Test
    void shouldShowAPreviewUntilTheImageIsThere() {
        Picture small = new Picture("a.png", 1, 1, new int[] {0x102030});
        Picture larger = new Picture("a.png", 2, 1, new int[] {0x102030, 0x405060});
        TextureImage first = images.of(previewing(small)).get("a.png");
        assertThat(first.argb()).containsExactly(0xff102030);
        TextureImage second = images.of(previewing(larger)).get("a.png");
        assertThat(second.argb()).containsExactly(0xff102030, 0xff405060);
        Picture image = new Picture("a.png", 3, 1, new int[] {1, 2, 3});
        Mesh arrived = new MeshBuilder()
                .textures(List.of(new Texture("a.png", image.bmp())))
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

    private static Mesh previewing(Picture picture) {
        return new MeshBuilder().previews(List.of(picture)).build();
    }
}
