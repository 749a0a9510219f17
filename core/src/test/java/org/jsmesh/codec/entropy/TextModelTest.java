package org.jsmesh.codec.entropy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.jsmesh.mesh.MalformedStreamException;
import org.junit.jupiter.api.Test;

class TextModelTest {
    @Test
    void shouldGiveBackAnyTexts() throws Exception {
        Random random = new Random(5);
        List<String> texts = new ArrayList<>(List.of("", "a", "Größe 面", "\u0000\u0001", "x".repeat(100_000)));
        for (int i = 0; i < 200; i++) {
            StringBuilder text = new StringBuilder();
            int kinds = 1 + random.nextInt(90);
            for (int n = random.nextInt(80); n > 0; n--) text.append((char) (' ' + random.nextInt(kinds)));
            texts.add(text.toString());
        }
        byte[] bytes = encode(texts);
        RangeDecoder in = new RangeDecoder(bytes, 0, bytes.length);
        TextModel model = new TextModel();
        for (String text : texts) assertThat(model.code(in, null)).isEqualTo(text);
        assertThat(in.isExhausted()).isFalse();
    }

    @Test
    void shouldCodeTextsThatAreAlikeInFewBytes() throws Exception {
        List<String> texts = new ArrayList<>();
        for (int i = 0; i < 100; i++)
            texts.add("{\"pbrMetallicRoughness\":{\"baseColorFactor\":[0." + i + ",0.5,0.25,1],\"metallicFactor\":0}}");
        assertThat(encode(texts).length).isLessThan(500);
        assertThat(encode(texts.subList(0, 1)).length).isLessThan(30);
    }

    @Test
    void shouldRefuseTextsOfImpossibleLength() throws Exception {
        byte[] ones = new byte[64];
        java.util.Arrays.fill(ones, (byte) 0xff);
        for (byte[] bytes : new byte[][] {new byte[64], ones, new byte[0]}) {
            RangeDecoder in = new RangeDecoder(bytes, 0, bytes.length);
            TextModel model = new TextModel();
            assertThatThrownBy(() -> {
                        while (true) model.code(in, null);
                    })
                    .isInstanceOf(MalformedStreamException.class);
        }
    }

    private static byte[] encode(List<String> texts) throws MalformedStreamException {
        RangeEncoder out = new RangeEncoder();
        TextModel model = new TextModel();
        for (String text : texts) model.code(out, text);
        return out.finish();
    }
}
