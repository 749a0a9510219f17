package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import org.jsmesh.mesh.Mesh;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Files of more than 2 GiB, which exist only while they are read. */
class HugeFilesTest {
    private static final long HUGE = (1L << 31) + 12_345_344;
    private static final String ZEROS = "\0".repeat(1 << 16);

    /** A file of two ends and much of the same between them. */
    private record Huge(byte[] start, byte[] filling, long count, byte[] end) implements ByteSource {
        Huge(String start, String filling, long count, byte[] end) {
            this(start.getBytes(StandardCharsets.US_ASCII), filling.getBytes(StandardCharsets.US_ASCII), count, end);
        }

        @Override
        public long length() {
            return start.length + count + end.length;
        }

        @Override
        public InputStream from(long offset) {
            return new InputStream() {
                private long at = offset;

                @Override
                public int read() {
                    byte[] one = new byte[1];
                    return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
                }

                @Override
                public int read(byte[] bytes, int to, int length) {
                    if (at == length()) return -1;
                    int read;
                    long behind = at - start.length - count;
                    if (at < start.length) {
                        read = (int) Math.min(length, start.length - at);
                        System.arraycopy(start, (int) at, bytes, to, read);
                    } else if (behind < 0) {
                        int from = (int) ((at - start.length) % filling.length);
                        read = (int) Math.min(Math.min(length, filling.length - from), -behind);
                        System.arraycopy(filling, from, bytes, to, read);
                    } else {
                        read = (int) Math.min(length, end.length - behind);
                        System.arraycopy(end, (int) behind, bytes, to, read);
                    }
                    at += read;
                    return read;
                }
            };
        }
    }

    private static ModelFile read(String name, ByteSource content) throws IOException {
        return ModelReader.read(name, content, ResourceResolver.NONE);
    }

    private static String line(String start) {
        return start + "-".repeat(4095 - start.length()) + "\n";
    }

    private static void assertTriangle(Mesh mesh) {
        assertThat(mesh.faces()).isEqualTo(1);
        assertThat(mesh.positions()).containsExactly(0, 0, 0, 1, 0, 0, 0, 1, 0);
    }

    private static byte[] triangle(int lastVertex) {
        ByteBuffer data = ByteBuffer.allocate(36 + 4).order(ByteOrder.LITTLE_ENDIAN);
        for (float x : new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}) data.putFloat(x);
        data.put(new byte[] {3, 0, 1, (byte) lastVertex});
        return data.array();
    }

    private static final String JUNK = "ply\nformat binary_little_endian 1.0\nelement junk " + HUGE / 8
            + "\nproperty double x\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
            + "element face 1\nproperty list uchar uchar vertex_indices\nend_header\n";

    @Test
    void shouldReadPlyBehindTwoGibibytesOfAnotherElement() throws IOException {
        ModelFile file = read("huge.ply", new Huge(JUNK, ZEROS, HUGE, triangle(2)));
        assertTriangle(file.mesh());
        assertThat(file.notes()).hasSize(1).allMatch(note -> note.text().contains("junk"));
    }

    @Test
    void shouldNameThePlaceOfAFaultBehindTwoGibibytes() {
        Huge damaged = new Huge(JUNK, ZEROS, HUGE, triangle(7));
        assertThatThrownBy(() -> read("huge.ply", damaged))
                .isInstanceOf(ModelFormatException.class)
                .hasMessageContaining("byte " + damaged.length())
                .hasMessageContaining("names vertex 7 of 3");
        Huge cut = new Huge(JUNK, ZEROS, HUGE, new byte[0]);
        assertThatThrownBy(() -> read("huge.ply", cut))
                .isInstanceOf(ModelFormatException.class)
                .hasMessageContaining("but 0 are left");
    }

    @Test
    void shouldReadStlWithTwoGibibytesBehindIt() throws IOException {
        ByteBuffer start = ByteBuffer.allocate(84 + 50).order(ByteOrder.LITTLE_ENDIAN);
        start.position(80).putInt(1).position(96);
        for (float x : new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}) start.putFloat(x);
        ModelFile file = read("huge.stl", new Huge(start.array(), new byte[1 << 16], HUGE, new byte[1]));
        assertTriangle(file.mesh());
        assertThat(file.notes().toString()).contains((HUGE + 1) + " bytes behind");
    }

    @Test
    void shouldRefuseOtherFormatsOfMoreThanTwoGibibytes() {
        assertThatThrownBy(() -> read("huge.off", new Huge("OFF\n", " ", HUGE, new byte[0])))
                .isInstanceOf(ModelFormatException.class)
                .hasMessageContaining("larger than 2 GiB")
                .hasMessageContaining("Convert it to PLY");
    }

    @Test
    void shouldRefuseMoreThanArraysHoldBeforeItReadsThem() {
        String faces = "ply\nformat binary_little_endian 1.0\nelement vertex 800000000\nproperty uchar x\n"
                + "property uchar y\nproperty uchar z\nelement face 1\nproperty list uchar uchar vertex_indices\n"
                + "end_header\n";
        assertThatThrownBy(() -> read("huge.ply", new Huge(faces, ZEROS, 3_000_000_000L, new byte[0])))
                .isInstanceOf(ModelFormatException.class)
                .hasMessageContaining("there are 800000000 vertices, more than the 715827879 that fit into memory")
                .hasMessageContaining("Cut the model into parts");
        String more = faces.replace("800000000", "3000000000");
        assertThatThrownBy(() -> read("huge.ply", new Huge(more, ZEROS, 9_000_000_000L, new byte[0])))
                .isInstanceOf(ModelFormatException.class)
                .hasMessageContaining("3000000000 elements \"vertex\" are more than fit into memory")
                .hasMessageContaining("Cut the model into parts");
        byte[] start = new byte[84];
        ByteBuffer.wrap(start).order(ByteOrder.LITTLE_ENDIAN).putInt(80, 1_000_000_000);
        assertThatThrownBy(() -> read("huge.stl", new Huge(start, new byte[1 << 16], 50_000_000_000L, new byte[0])))
                .isInstanceOf(ModelFormatException.class)
                .hasMessageContaining("there are 1000000000 facets, more than the 715827879 that fit into memory");
    }

    @Test
    @Tag("long") // two passes of bytes one by one
    void shouldReadTextsBehindTwoGibibytesOfComments() throws IOException {
        String ply = "\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
                + "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
        assertTriangle(read(
                        "huge.ply",
                        new Huge(
                                "ply\nformat ascii 1.0\n",
                                line("comment "),
                                HUGE,
                                ply.getBytes(StandardCharsets.US_ASCII)))
                .mesh());
        String obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
        assertTriangle(read("huge.obj", new Huge("# obj\n", line("#"), HUGE, obj.getBytes(StandardCharsets.US_ASCII)))
                .mesh());
        String stl = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
        assertTriangle(
                read("huge.stl", new Huge("solid\n", line("facet "), HUGE, stl.getBytes(StandardCharsets.US_ASCII)))
                        .mesh());
    }
}
