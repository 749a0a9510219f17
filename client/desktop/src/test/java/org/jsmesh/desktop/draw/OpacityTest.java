package org.jsmesh.desktop.draw;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.jsmesh.studio.Opacity;
import org.junit.jupiter.api.Test;

class OpacityTest {
    private static int[] pixels(int... alphas) {
        return Arrays.stream(alphas).map(alpha -> alpha << 24 | 0x649632).toArray();
    }

    @Test
    void shouldBeOpaqueWhereAllIsSeenOrNothing() {
        assertThat(Opacity.of(pixels(255, 255, 250))).isEqualTo(Opacity.OPAQUE);
        assertThat(Opacity.of(pixels(0, 0, 0))).isEqualTo(Opacity.OPAQUE);
    }

    @Test
    void shouldTellHolesFromGlassByThePixelsBetween() {
        assertThat(Opacity.of(pixels(255, 255, 0, 0, 128))).isEqualTo(Opacity.HOLES);
        assertThat(Opacity.of(pixels(255, 255, 15))).isEqualTo(Opacity.HOLES);
        assertThat(Opacity.of(pixels(255, 128, 128, 0))).isEqualTo(Opacity.GLASS);
        assertThat(Opacity.of(pixels(128, 128))).isEqualTo(Opacity.GLASS);
    }

    @Test
    void shouldMaskByAlphaOrElseByBrightness() {
        TextureImage holes = TextureImage.of(3, 1, pixels(255, 0, 128));
        assertThat(holes.mask().argb()).containsExactly(pixels(255, 0, 128));
        TextureImage plain = TextureImage.of(3, 1, new int[] {0xffffffff, 0xff000000, 0xff00ff00});
        assertThat(plain.mask().argb()).containsExactly(0xff000000, 0, 182 << 24);
        assertThat(plain.mask().opacity()).isEqualTo(Opacity.HOLES);
    }
}
