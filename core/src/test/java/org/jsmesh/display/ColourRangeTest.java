package org.jsmesh.display;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.BitSet;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.junit.jupiter.api.Test;

class ColourRangeTest {
    private static int[] bits(float... values) {
        int[] bits = new int[values.length];
        for (int i = 0; i < bits.length; i++) bits[i] = Float.floatToRawIntBits(values[i]);
        return bits;
    }

    private static Channel colour(Channel.Type type, int... values) {
        return new Channel(Channel.Semantic.COLOUR, "colour", 3, type, values, null);
    }

    private static double ofFloats(float... values) {
        return ColourRange.full(colour(Channel.Type.FLOAT32, bits(values)));
    }

    @Test
    void shouldTakeWholeNumbersBeyondOneForBytesOrWords() {
        assertThat(ofFloats(0, 1, 0)).isEqualTo(1);
        assertThat(ofFloats(0, 2, 0)).isEqualTo(255);
        assertThat(ofFloats(0, 255, 0)).isEqualTo(255);
        assertThat(ofFloats(0, 256, 0)).isEqualTo(65535);
        assertThat(ofFloats(0, 65535, 0)).isEqualTo(65535);
    }

    @Test
    void shouldTakeFractionsForPartsOfOneUnlessTheyAreFarBeyond() {
        assertThat(ofFloats(.5f, 1, 0)).isEqualTo(1);
        assertThat(ofFloats(.5f, 1.25f, 3)).isEqualTo(1);
        assertThat(ofFloats(127.5f, 200.25f, 0)).isEqualTo(255);
        assertThat(ofFloats(-1, -300, 0)).isEqualTo(1);
    }

    @Test
    void shouldKnowTheRangeOfSmallIntegersByTheirTypeAndOfOthersByTheirValues() {
        assertThat(ColourRange.full(colour(Channel.Type.UINT8, 0, 3, 1))).isEqualTo(1);
        assertThat(ColourRange.full(colour(Channel.Type.UINT16, 0, 65535, 300))).isEqualTo(1);
        assertThat(ColourRange.full(colour(Channel.Type.INT32, 0, 200, 1))).isEqualTo(255);
        assertThat(ColourRange.full(colour(Channel.Type.UINT32, 0, 40000, 1))).isEqualTo(65535);
        assertThat(ColourRange.full(colour(Channel.Type.UINT32, 0, -1, 1))).isEqualTo(4294967295.0);
        assertThat(ColourRange.full(colour(Channel.Type.INT32, 0, 70000, 1))).isEqualTo(2147483647.0);
    }

    @Test
    void shouldPassOverWedgesWithoutAColour() {
        BitSet absent = new BitSet();
        absent.set(1);
        Channel channel = new Channel(
                Channel.Semantic.COLOUR, "colour", 3, Channel.Type.FLOAT32, bits(255, 7, 0, .5f, .5f, 0), absent);
        assertThat(ColourRange.full(channel)).isEqualTo(255);
    }

    @Test
    void shouldDrawColoursFrom0To255InTheirRange() {
        int[] values = bits(127, 0, 255, 255, 255, 255, 1, 2, 3);
        Mesh mesh = new MeshBuilder()
                .positions(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0})
                .faceWedges(new int[] {0, 1, 2})
                .channels(java.util.List.of(colour(Channel.Type.FLOAT32, values)))
                .build();
        assertThat(RenderMesh.of(mesh, .7).colours()).containsExactly(0xffff007f, 0xffffffff, 0xff030201);
    }
}
