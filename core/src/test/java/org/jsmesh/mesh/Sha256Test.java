package org.jsmesh.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.Random;
import org.junit.jupiter.api.Test;

class Sha256Test {
    @Test
    void shouldAgreeWithThePlatform() throws Exception {
        Random random = new Random(1);
        for (int length = 0; length < 300; length++) {
            byte[] bytes = new byte[length];
            random.nextBytes(bytes);
            String expected = HexFormat.of()
                    .formatHex(MessageDigest.getInstance("SHA-256").digest(bytes));
            assertThat(Sha256.hex(bytes)).isEqualTo(expected);
            Sha256 parts = new Sha256();
            int cut = length == 0 ? 0 : random.nextInt(length);
            parts.update(bytes, 0, cut);
            parts.update(bytes, cut, length - cut);
            assertThat(Sha256.toHex(parts.digest())).isEqualTo(expected);
        }
    }
}
