package org.jsmesh.session;

import java.nio.ByteBuffer;
import java.security.MessageDigest;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Random;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.BatchIndexBuilder;
import org.jsmesh.archive.BatchKind;
import org.jsmesh.archive.Proof;
import org.jsmesh.archive.Provenance;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.UpAxis;

/**
 * Archives of noise with the batches of real ones, so that megabytes can be streamed without encoding a mesh: count,
 * sizes, then batches that each end with a check byte.
 */
final class FakeArchive {
    private FakeArchive() {}

    static byte[] of(int baseBytes, int archiveBytes, long seed) {
        int[] sizes = new int[archiveBytes];
        int n = 0;
        for (int at = 0; at < archiveBytes; n++) {
            int size = n == 0 ? baseBytes : Math.min(Math.max(1024, at / 20), 65536);
            sizes[n] = Math.min(size, archiveBytes - at);
            at += sizes[n];
        }
        byte[] bytes = new byte[archiveBytes];
        new Random(seed).nextBytes(bytes);
        ByteBuffer head = ByteBuffer.wrap(bytes).putInt(n);
        for (int i = 0; i < n; i++) head.putInt(sizes[i]);
        int at = 0;
        for (int i = 0; i < n; i++) {
            at += sizes[i];
            bytes[at - 1] = check(bytes, at - sizes[i], at - 1);
        }
        return bytes;
    }

    private static byte check(byte[] bytes, int from, int to) {
        byte sum = 1;
        for (int i = from; i < to; i++) sum = (byte) (31 * sum + bytes[i]);
        return sum;
    }

    static String sha256(byte[] bytes) {
        MessageDigest digest = ReceivedArchive.sha256();
        return HexFormat.of().formatHex(digest.digest(bytes));
    }

    /**
     * A decoder of such archives.
     *
     * @param promise identity that the header states
     */
    static MeshStream decoder(String promise) {
        return new MeshStream() {
            private byte[] bytes = new byte[0];
            private ArchiveHeader header;
            private int batches;

            @Override
            public void feed(byte[] more, int offset, int length) throws MalformedStreamException {
                if (isComplete()) throw new MalformedStreamException(bytes.length, "bytes after the end");
                int before = bytes.length;
                bytes = Arrays.copyOf(bytes, before + length);
                System.arraycopy(more, offset, bytes, before, length);
                if (header == null) readHeader();
                BatchIndex index = header == null ? null : header.batches();
                while (index != null && batches < index.size() && index.end(batches) <= bytes.length) {
                    int end = (int) index.end(batches) - 1;
                    if (check(bytes, (int) index.offset(batches), end) != bytes[end]) {
                        throw new MalformedStreamException(end, "batch " + batches + " is damaged");
                    }
                    batches++;
                }
            }

            private void readHeader() {
                ByteBuffer head = ByteBuffer.wrap(bytes);
                if (bytes.length < 4 || bytes.length < 4 + 4 * head.getInt(0)) return;
                BatchIndexBuilder builder = new BatchIndexBuilder();
                int n = head.getInt();
                for (int i = 0; i < n; i++) {
                    builder.add(i == 0 ? BatchKind.BASE : BatchKind.SPLITS, head.getInt(), i)
                            .after(10 * (i + 1), 5 * (i + 1), 1.0 / (i + 1));
                }
                header = new ArchiveHeader(
                        10 * n,
                        5 * n,
                        5 * n,
                        List.of(),
                        List.of(),
                        List.of(),
                        List.of(),
                        new double[3],
                        new float[6],
                        UpAxis.UNKNOWN,
                        false,
                        List.of(),
                        promise,
                        Provenance.NONE,
                        builder.build());
            }

            @Override
            public ArchiveHeader header() {
                return header;
            }

            @Override
            public int batches() {
                return batches;
            }

            @Override
            public boolean isComplete() {
                return header != null && batches == header.batches().size();
            }

            @Override
            public Mesh mesh() {
                int faces = batches == 0 ? 0 : header.batches().faces(batches - 1);
                return new MeshBuilder()
                        .positions(new float[9])
                        .faceWedges(new int[3 * faces])
                        .build();
            }

            @Override
            public Proof prove(Mesh mesh) {
                return new Proof(sha256(bytes), "", promise, List.of());
            }
        };
    }
}
