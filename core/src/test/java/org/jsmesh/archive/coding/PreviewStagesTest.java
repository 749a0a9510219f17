package org.jsmesh.archive.coding;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Random;
import org.jsmesh.archive.ImageInfo;
import org.jsmesh.codec.PreviewCoder;
import org.jsmesh.codec.PreviewModel;
import org.jsmesh.codec.entropy.RangeEncoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.junit.jupiter.api.Test;

class PreviewStagesTest {
    @Test
    void shouldRefuseThePreviewOfNoTexture() throws Exception {
        byte[] stage = stage(3);
        assertThatThrownBy(() -> new PreviewStages().decode(stage, 0, stage.length, 3))
                .isInstanceOf(MalformedStreamException.class)
                .hasMessageContaining("image 3");
    }

    @Test
    void shouldRefuseMorePixelsThanMemoryIsFor() throws Exception {
        PreviewStages stages = new PreviewStages();
        PreviewModel model = new PreviewModel();
        int largest = PreviewStages.MOST_PIXELS / PreviewCoder.LARGEST / PreviewCoder.LARGEST; // previews
        for (int image = 0; image < largest; image++) {
            PreviewCoder coder = new PreviewCoder(model);
            for (int side = 16; side <= PreviewCoder.LARGEST; side *= 2) {
                byte[] stage = stage(coder, image, side);
                stages.decode(stage, 0, stage.length, 4096);
            }
        }
        byte[] oneMore = stage(new PreviewCoder(model), largest, 16);
        assertThatThrownBy(() -> stages.decode(oneMore, 0, oneMore.length, 4096))
                .isInstanceOf(MalformedStreamException.class)
                .hasMessageContaining("pixels");
    }

    @Test
    void shouldThrowNothingElseForRandomBytes() {
        Random random = new Random(7);
        int refused = 0;
        for (int i = 0; i < 2000; i++) {
            byte[] bytes = new byte[random.nextInt(60)];
            random.nextBytes(bytes);
            if (bytes.length > 1) bytes[0] = bytes[1] = 0; // a texture that is there
            PreviewStages stages = new PreviewStages();
            try {
                for (int k = 0; k < 3; k++) stages.decode(bytes, 0, bytes.length, 2);
            } catch (MalformedStreamException e) {
                refused++;
            }
        }
        assertThat(refused).isGreaterThan(100);
    }

    @Test
    void shouldShowNoPreviewOfWhatHasArrived() throws Exception {
        PreviewStages stages = new PreviewStages();
        byte[] stage = stage(1);
        stages.decode(stage, 0, stage.length, 2);
        List<ImageInfo> textures = List.of(new ImageInfo(List.of("a.png"), 9), new ImageInfo(List.of("b.png"), 9));
        assertThat(stages.pictures(textures, 1))
                .singleElement()
                .satisfies(p -> assertThat(p.path()).isEqualTo("b.png"));
        assertThat(stages.pictures(textures, 2)).isEmpty();
    }

    /** A first stage of 16 × 16 pixels of one colour. */
    private static byte[] stage(int image) throws MalformedStreamException {
        return stage(new PreviewCoder(new PreviewModel()), image, 16);
    }

    private static byte[] stage(PreviewCoder coder, int image, int side) throws MalformedStreamException {
        RangeEncoder stream = new RangeEncoder();
        PreviewStages.codeImage(stream, image);
        boolean[] free = new boolean[side * side];
        coder.codePortion(
                stream, new PreviewCoder.Wanted(side, side, 8, false, new int[side * side], free), () -> false);
        return stream.finish();
    }
}
