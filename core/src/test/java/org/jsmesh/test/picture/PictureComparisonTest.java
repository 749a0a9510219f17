package org.jsmesh.test.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import org.junit.jupiter.api.Test;

class PictureComparisonTest {
    private static final int CLEAR = 0;
    private static final int BLACK = 0xff000000;
    private static final int WHITE = 0xffffffff;

    private static BufferedImage row(int... pixels) {
        BufferedImage picture = new BufferedImage(pixels.length, 1, BufferedImage.TYPE_INT_ARGB);
        for (int i = 0; i < pixels.length; i++) picture.setRGB(i, 0, pixels[i]);
        return picture;
    }

    @Test
    void shouldCompareOnlyPixelsThatEitherPictureShows() {
        assertThat(PictureComparison.visibleDifference(row(CLEAR, WHITE), row(CLEAR, WHITE)))
                .isZero();
        assertThat(PictureComparison.visibleDifference(row(CLEAR, BLACK, WHITE), row(CLEAR, WHITE, WHITE)))
                .isEqualTo(.5);
    }

    @Test
    void shouldSeeOpacityBeforeBlackAndBeforeWhite() {
        assertThat(PictureComparison.visibleDifference(row(CLEAR), row(WHITE))).isEqualTo(1);
        assertThat(PictureComparison.visibleDifference(row(CLEAR), row(BLACK))).isEqualTo(1);
        assertThat(PictureComparison.visibleDifference(row(0x80ff0000), row(0xffff0000)))
                .isEqualTo(127 * 2 / 3. / 255, within(1e-9));
    }

    @Test
    void shouldRefuseBlankPictures() {
        assertThatThrownBy(() -> PictureComparison.visibleDifference(row(CLEAR), row(CLEAR)))
                .hasMessageContaining("blank");
    }
}
