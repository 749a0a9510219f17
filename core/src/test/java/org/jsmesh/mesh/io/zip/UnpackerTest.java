package org.jsmesh.mesh.io.zip;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.Random;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;

class UnpackerTest {
    private static byte[] gzip(byte[] content) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (GZIPOutputStream packed = new GZIPOutputStream(out)) {
            packed.write(content);
        }
        return out.toByteArray();
    }

    private static byte[] noise(int bytes) {
        byte[] noise = new byte[bytes];
        new Random(1).nextBytes(noise);
        return noise;
    }

    private static byte[] join(byte[] a, byte[] b) {
        byte[] both = Arrays.copyOf(a, a.length + b.length);
        System.arraycopy(b, 0, both, a.length, b.length);
        return both;
    }

    @Test
    void shouldUnpackGzipOfSeveralMembers() throws IOException {
        byte[] content = noise(100_000);
        byte[] packed = join(gzip(content), gzip(new byte[] {7}));
        assertThat(Unpacker.isGzip(packed)).isTrue();
        byte[] unpacked = new Unpacker(200_000).gunzip(packed);
        assertThat(unpacked).isEqualTo(join(content, new byte[] {7}));
    }

    @Test
    void shouldUnpackAsMuchAsAllowedAndNoByteMore() throws IOException {
        byte[] packed = gzip(noise(1000));
        assertThat(new Unpacker(1000).gunzip(packed)).hasSize(1000);
        assertThatThrownBy(() -> new Unpacker(999).gunzip(packed))
                .isInstanceOf(PackedException.class)
                .hasMessage("the gzip file unpacks to more bytes than allowed");
        Unpacker twice = new Unpacker(1500);
        twice.gunzip(packed);
        assertThatThrownBy(() -> twice.gunzip(packed)).hasMessageContaining("more bytes than allowed");
    }

    @Test
    void shouldRefuseBombs() throws IOException {
        byte[] packed = gzip(new byte[10_000_000]);
        assertThat(packed).hasSizeLessThan(20_000);
        assertThatThrownBy(() -> new Unpacker(Unpacker.MOST_BYTES).gunzip(packed))
                .isInstanceOf(PackedException.class)
                .hasMessageContaining("more than 250 times its bytes");
    }

    @Test
    void shouldRefuseGzipThatIsDamagedOrCutOff() throws IOException {
        byte[] packed = gzip(noise(1000));
        for (int length = 18; length < packed.length; length += 50) {
            byte[] cut = Arrays.copyOf(packed, length);
            assertThatThrownBy(() -> new Unpacker(10_000).gunzip(cut))
                    .isInstanceOf(PackedException.class)
                    .hasMessage("the gzip file is cut off");
        }
        packed[500] ^= 1;
        assertThatThrownBy(() -> new Unpacker(10_000).gunzip(packed))
                .isInstanceOf(PackedException.class)
                .hasMessage("the gzip file is damaged");
    }
}
