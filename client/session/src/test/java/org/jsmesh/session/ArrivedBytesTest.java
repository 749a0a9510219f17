package org.jsmesh.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

class ArrivedBytesTest {
    @Test
    void shouldGiveBackWhatWasPutInInAnyPortions() throws IOException {
        byte[] original = new byte[300_000];
        Random random = new Random(1);
        random.nextBytes(original);
        ArrivedBytes arrived = new ArrivedBytes();
        for (int at = 0; at < original.length; ) {
            int count = Math.min(original.length - at, random.nextInt(100_000));
            arrived.append(original, at, count);
            at += count;
            assertThat(arrived.length()).isEqualTo(at);
        }
        assertThat(all(arrived)).isEqualTo(original);
        byte[] part = new byte[150_000];
        assertThat(arrived.copy(65_000, part, 150_000)).isEqualTo(150_000);
        assertThat(part).isEqualTo(Arrays.copyOfRange(original, 65_000, 215_000));
    }

    @Test
    void shouldGiveNoMoreThanHasArrived() throws IOException {
        ArrivedBytes arrived = new ArrivedBytes();
        assertThat(all(arrived)).isEmpty();
        arrived.append(new byte[] {1, 2, 3, 4}, 1, 2);
        byte[] part = new byte[10];
        assertThat(arrived.copy(1, part, 10)).isEqualTo(1);
        assertThat(part[0]).isEqualTo((byte) 3);
        assertThat(arrived.copy(2, part, 10)).isZero();
        assertThatThrownBy(() -> arrived.copy(3, part, 10)).hasMessageContaining("byte 3 of 2");
    }

    private static byte[] all(ArrivedBytes arrived) throws IOException {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        arrived.writeTo(all);
        return all.toByteArray();
    }
}
