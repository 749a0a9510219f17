package org.jsmesh.load;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.util.HexFormat;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** A load test that overlooks what is wrong would be worth nothing. */
class DownloadTest {
    private final byte[] bytes = new byte[1000];
    private final Model model;

    DownloadTest() {
        new Random(1).nextBytes(bytes);
        String sha256 = HexFormat.of().formatHex(Model.newDigest().digest(bytes));
        model = new Model("model", bytes, sha256, "", null);
    }

    private ByteBuffer bytes(int from, int to) {
        return ByteBuffer.wrap(bytes.clone(), from, to - from);
    }

    @Test
    void shouldJoinBytesToTheOriginal() {
        Download download = new Download(model, true);
        assertThat(download.take(0, bytes(0, 300))).isNull();
        assertThat(download.isComplete()).isFalse();
        assertThat(download.take(300, bytes(300, 1000))).isNull();
        assertThat(download.received()).isEqualTo(1000);
        assertThat(download.sentTwice()).isZero();
        assertThat(download.isOriginal()).isTrue();
        assertThat(download.kept()).isEqualTo(bytes);
    }

    @Test
    void shouldCountBytesThatComeTwice() {
        Download download = new Download(model, false);
        download.take(0, bytes(0, 300));
        assertThat(download.take(200, bytes(200, 1000))).isNull();
        assertThat(download.sentTwice()).isEqualTo(100);
        assertThat(download.isOriginal()).isTrue();
    }

    @Test
    void shouldNoticeAWrongByte() {
        Download download = new Download(model, false);
        ByteBuffer wrong = bytes(0, 300);
        wrong.put(123, (byte) (wrong.get(123) ^ 1));
        assertThat(download.take(0, wrong)).contains("byte 123");
    }

    @Test
    void shouldNoticeGapsAndBytesBehindTheEnd() {
        Download download = new Download(model, false);
        assertThat(download.take(1, bytes(1, 2))).contains("from 1");
        assertThat(download.take(0, ByteBuffer.wrap(new byte[1001]))).contains("more bytes");
    }
}
