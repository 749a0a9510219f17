package org.jsmesh.archive.coding;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Random;
import org.jsmesh.archive.TextureInfo;
import org.jsmesh.codec.PreviewCoder;
import org.jsmesh.codec.entropy.RangeEncoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.junit.jupiter.api.Test;

class PreviewStagesTest {
    @Test
    void shouldRefuseThePreviewOfNoTexture() throws Exception {
        byte[] stage = stage(3);
        assertThatThrownBy(() -> new PreviewStages().decode(stage, 0, stage.length, 3))
                .isInstanceOf(MalformedStreamException.class)
                .hasMessageContaining("texture 3");
    }

    @Test
    void shouldRefuseMorePixelsThanMemoryIsFor() {
        PreviewStages stages = new PreviewStages();
        assertThatThrownBy(() -> {
                    for (int texture = 0; texture < 4096; texture++) {
                        byte[] stage = new byte[20_000];
                        stage[0] = (byte) (texture >> 4);
                        stage[1] = (byte) (texture << 4);
                        for (int k = 0; k < 4; k++) stages.decode(stage, 0, stage.length, 4096);
                    }
                })
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
        List<TextureInfo> textures = List.of(new TextureInfo("a.png", 9), new TextureInfo("b.png", 9));
        assertThat(stages.pictures(textures, 1))
                .singleElement()
                .satisfies(p -> assertThat(p.path()).isEqualTo("b.png"));
        assertThat(stages.pictures(textures, 2)).isEmpty();
    }

    /** A first stage of 16 × 16 pixels of one colour. */
    private static byte[] stage(int texture) throws MalformedStreamException {
        RangeEncoder stream = new RangeEncoder();
        PreviewStages.codeTexture(stream, texture);
        int[] rgb = new int[256];
        new PreviewCoder().codeStage(stream, 16, 16, rgb);
        return stream.finish();
    }
}
