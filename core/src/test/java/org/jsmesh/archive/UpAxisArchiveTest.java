package org.jsmesh.archive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import org.jsmesh.archive.coding.ArchiveLayout;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class UpAxisArchiveTest {
    private static EncodedArchive encode(UpAxis up) {
        EncoderSettings settings = EncoderSettings.defaults().withUp(up);
        return new MeshEncoder(settings).encode(RandomMeshes.SPHERE.mesh(1), ProgressListener.NONE);
    }

    @ParameterizedTest
    @EnumSource
    void shouldBeKnownWithTheOpening(UpAxis up) throws Exception {
        byte[] bytes = encode(up).bytes();
        ArchiveDecoder decoder = new ArchiveDecoder();
        for (int at = 0; decoder.opening() == null; at++) decoder.feed(bytes, at, 1);
        assertThat(decoder.opening().up()).isEqualTo(up);
        assertThat(encode(up).header().up()).isEqualTo(up);
    }

    @ParameterizedTest
    @EnumSource
    void shouldCostNoByteAndChangeNothingElse(UpAxis up) {
        byte[] bytes = encode(up).bytes();
        byte[] unknown = encode(UpAxis.UNKNOWN).bytes();
        assertThat(bytes[ArchiveLayout.FEATURES_AT] ^ unknown[ArchiveLayout.FEATURES_AT])
                .isEqualTo((byte) (up.ordinal() << 6));
        int differences = 0;
        for (int i = 0; i < bytes.length; i++) differences += bytes[i] == unknown[i] ? 0 : 1;
        assertThat(differences).as("the byte, and a checksum").isLessThanOrEqualTo(1 + ArchiveLayout.CRC_BYTES);
        assertThat(bytes).hasSameSizeAs(unknown);
    }

    @Test
    void shouldRefuseAnAxisThatIsNone() {
        EncodedArchive archive = encode(UpAxis.Z);
        byte[] bytes = Arrays.copyOf(archive.bytes(), archive.bytes().length);
        bytes[ArchiveLayout.FEATURES_AT] |= (byte) 0xc0;
        Checksums.mend(bytes, archive.header().batches());
        assertThatThrownBy(() -> new ArchiveDecoder().feed(bytes, 0, bytes.length))
                .isInstanceOf(MalformedStreamException.class)
                .hasMessageContaining("points up");
    }
}
