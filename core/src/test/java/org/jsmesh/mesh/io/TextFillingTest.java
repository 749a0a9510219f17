package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TextFillingTest {
    /** Counts what is asked of it, bytes before the place where a reading begins included, as a packed source must. */
    private static final class Counting implements ByteSource {
        private final byte[] content;
        private long passed;
        private int opened;
        private int closed;

        Counting(byte[] content) {
            this.content = content;
        }

        @Override
        public long length() {
            return content.length;
        }

        @Override
        public InputStream from(long offset) {
            opened++;
            passed += offset;
            return new FilterInputStream(
                    new ByteArrayInputStream(content, (int) offset, content.length - (int) offset)) {
                @Override
                public int read(byte[] bytes, int at, int length) throws IOException {
                    int count = super.read(bytes, at, Math.min(length, 10_007));
                    passed += Math.max(0, count);
                    return count;
                }

                @Override
                public void close() {
                    closed++;
                }
            };
        }
    }

    @ParameterizedTest
    @CsvSource({
        "0, 0",
        "0, 1",
        "1, 0",
        "1, 65535",
        "1, 65536",
        "65536, 65536",
        "100000, 3000000",
        "100000, 1",
        "0, 200000"
    })
    void shouldBeFoundInTwoReadings(int text, int filling) throws IOException {
        byte[] content = new byte[text + filling];
        Arrays.fill(content, 0, text, (byte) ' ');
        if (filling > 0) content[content.length - 1] = 0x1A;
        Counting source = new Counting(content);
        assertThat(TextFilling.end(source)).isEqualTo(text);
        assertThat(source.passed).isLessThanOrEqualTo(2L * content.length);
        assertThat(source.closed).isEqualTo(source.opened);
        assertThat(TextFilling.end(ByteSource.of(content))).isEqualTo(text);
        assertThat(TextFilling.without(content)).hasSize(text);
    }

    @Test
    void shouldNotEndAtFillingWithinTheText() throws IOException {
        byte[] content = new byte[300_000];
        content[100] = 'v';
        content[150_000] = 'f';
        assertThat(TextFilling.end(new Counting(content))).isEqualTo(150_001);
    }

    @Test
    void shouldForgetWhatIsClosed() throws IOException {
        Counting counting = new Counting(new byte[10]);
        ByteSource opened = OpenedSource.of(counting);
        for (int i = 0; i < 3; i++) opened.from(0).close();
        opened.from(0);
        assertThat(counting.closed).isEqualTo(3);
        OpenedSource.close(opened);
        assertThat(counting.closed).isEqualTo(4);
    }

    @Test
    void shouldNotKeepCommentsInMemory() throws IOException {
        byte[] comment = new byte[3 << 20];
        Arrays.fill(comment, (byte) '#');
        byte[] end = "\nv".getBytes(StandardCharsets.US_ASCII);
        byte[] content = Arrays.copyOf(comment, comment.length + end.length);
        System.arraycopy(end, 0, content, comment.length, end.length);
        TextScanner scanner = new TextScanner("a.obj", new Counting(content), content.length, true, true);
        assertThat(scanner.next()).isTrue();
        assertThat(scanner.token()).isEqualTo("v");
        assertThat(scanner.line()).isEqualTo(2);
        assertThat(scanner.bytes.length).isLessThan(1 << 20);
    }
}
