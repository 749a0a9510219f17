package org.jsmesh.mesh.io.zip;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.zip.CRC32;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.Test;

class ZipArchiveTest {
    private static byte[] zip(int method, String... namesAndTexts) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(out)) {
            zip.setComment("a comment");
            for (int i = 0; i < namesAndTexts.length; i += 2) {
                byte[] bytes = namesAndTexts[i + 1].getBytes(StandardCharsets.UTF_8);
                ZipEntry entry = new ZipEntry(namesAndTexts[i]);
                entry.setMethod(method);
                entry.setSize(bytes.length);
                CRC32 crc = new CRC32();
                crc.update(bytes);
                entry.setCrc(crc.getValue());
                zip.putNextEntry(entry);
                zip.write(bytes);
            }
        }
        return out.toByteArray();
    }

    private static ZipArchive open(byte[] content) throws PackedException {
        assertThat(ZipArchive.isZip(content)).isTrue();
        return new ZipArchive(content, new Unpacker(1000));
    }

    private static String text(byte[] bytes) {
        return new String(bytes, StandardCharsets.UTF_8);
    }

    @Test
    void shouldUnpackStoredAndDeflatedFilesByName() throws IOException {
        for (int method : new int[] {ZipEntry.STORED, ZipEntry.DEFLATED}) {
            ZipArchive zip = open(zip(method, "b\\c.txt", "hello", "ä/", "", "a.txt", ""));
            assertThat(zip.names()).containsExactly("b/c.txt", "a.txt");
            assertThat(text(zip.find("b/c.txt"))).isEqualTo("hello");
            assertThat(zip.find("a.txt")).isEmpty();
            assertThat(zip.find("c.txt")).isNull();
        }
    }

    @Test
    void shouldFindFilesBehindOtherBytes() throws IOException {
        byte[] plain = zip(ZipEntry.DEFLATED, "a.txt", "hello");
        byte[] content = new byte[plain.length + 5];
        System.arraycopy(plain, 0, content, 5, plain.length);
        ZipArchive zip = new ZipArchive(content, new Unpacker(1000));
        assertThat(text(zip.find("a.txt"))).isEqualTo("hello");
    }

    /** As programs write them that do not know the length when they begin. */
    @Test
    void shouldReadTheEndOfZip64() throws IOException {
        byte[] plain = zip(ZipEntry.STORED, "a.txt", "hello");
        int end = plain.length - 22 - "a comment".length();
        ByteBuffer old = ByteBuffer.wrap(plain).order(ByteOrder.LITTLE_ENDIAN);
        ByteBuffer wide = ByteBuffer.allocate(end + 56 + 20 + 22).order(ByteOrder.LITTLE_ENDIAN);
        wide.put(plain, 0, end)
                .putInt(0x06064B50)
                .putLong(44)
                .putInt(0)
                .putLong(0)
                .putLong(1)
                .putLong(1);
        wide.putLong(old.getInt(end + 12)).putLong(old.getInt(end + 16));
        wide.putInt(0x07064B50).putInt(0).putLong(end).putInt(1);
        wide.putInt(0x06054B50)
                .putInt(0)
                .putShort((short) -1)
                .putShort((short) -1)
                .putInt(-1)
                .putInt(-1);
        assertThat(text(open(wide.array()).find("a.txt"))).isEqualTo("hello");
    }

    @Test
    void shouldRefuseMoreBytesThanAllowed() throws IOException {
        ZipArchive zip = open(zip(ZipEntry.DEFLATED, "a", "x".repeat(600), "b", "x".repeat(600)));
        assertThat(zip.find("a")).hasSize(600);
        assertThatThrownBy(() -> zip.find("b"))
                .isInstanceOf(PackedException.class)
                .hasMessage("the ZIP archive unpacks to more bytes than allowed");
    }

    @Test
    void shouldRefuseEncryptedFilesAndOtherMethods() throws IOException {
        byte[] content = zip(ZipEntry.STORED, "a.txt", "hello");
        int central = content.length - 22 - "a comment".length() - 46 - "a.txt".length();
        byte[] encrypted = content.clone();
        encrypted[central + 8] |= 1;
        assertThatThrownBy(() -> open(encrypted).find("a.txt")).hasMessage("the ZIP archive is encrypted");
        byte[] other = content.clone();
        other[central + 10] = 14;
        assertThatThrownBy(() -> open(other).find("a.txt")).hasMessageContaining("packed by method 14");
    }

    @Test
    void shouldRefuseEveryTruncationAndDamagedBytes() throws IOException {
        byte[] content = zip(ZipEntry.DEFLATED, "a.txt", "hello hello hello");
        for (int length = 22; length < content.length - "a comment".length(); length++) {
            byte[] cut = Arrays.copyOf(content, length);
            assertThatThrownBy(() -> open(cut)).as("%d bytes", length).isInstanceOf(PackedException.class);
        }
        content[30 + "a.txt".length() + 3] ^= 8;
        assertThatThrownBy(() -> open(content).find("a.txt"))
                .isInstanceOf(PackedException.class)
                .hasMessageContaining("damaged");
    }

    @Test
    void shouldThrowNothingElseWhateverByteIsAltered() throws IOException {
        byte[] content = zip(ZipEntry.DEFLATED, "a.txt", "hello hello hello", "b.txt", "x");
        for (int at = 4; at < content.length; at++) {
            for (int bit = 0; bit < 8; bit++) {
                byte[] altered = content.clone();
                altered[at] ^= (byte) (1 << bit);
                try {
                    ZipArchive zip = open(altered);
                    for (String name : zip.names()) zip.find(name);
                } catch (PackedException e) {
                    assertThat(e.reason()).isNotBlank();
                    assertThat(e.remedy()).isNotBlank();
                }
            }
        }
    }
}
