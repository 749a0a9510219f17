package org.jsmesh.archive.coding;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.jsmesh.codec.entropy.IntegerModel;
import org.jsmesh.codec.entropy.RangeDecoder;
import org.jsmesh.codec.entropy.RangeEncoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class HeaderCoderTest {
    @ParameterizedTest
    @CsvSource({"2, 9", "5, 10", "1073741824, 38"})
    void shouldNameAFurtherFeatureThatItDoesNotKnow(int further, int feature) throws Exception {
        RangeEncoder encoder = new RangeEncoder();
        new IntegerModel(1).unsigned(encoder, further);
        byte[] bytes = encoder.finish();
        RangeDecoder decoder = new RangeDecoder(bytes, 0, bytes.length);
        assertThatThrownBy(() -> new HeaderCoder(null, null, null, ArchiveLayout.FURTHER).codeOpening(decoder, 0, 0))
                .isInstanceOf(MalformedStreamException.class)
                .hasMessageContaining("needs feature " + feature)
                .hasMessageContaining("a newer jSM may read it");
    }
}
