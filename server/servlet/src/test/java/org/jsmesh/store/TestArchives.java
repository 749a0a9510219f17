package org.jsmesh.store;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Random;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.BatchIndexBuilder;
import org.jsmesh.archive.BatchKind;
import org.jsmesh.archive.Provenance;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.UpAxis;

/**
 * Files of random bytes with a trivial index in front, which the servers take for archives: they know nothing of
 * meshes.
 */
public final class TestArchives {
    private static final int MAGIC = 0x54455354;
    private static final int MAGIC_WITH_POSTER = MAGIC + 1;

    /** Reads the trivial index. */
    static final HeaderReader READER = TestArchives::header;

    private TestArchives() {}

    /** A file whose batches have those sizes; the first needs room for the index. */
    public static byte[] of(long seed, int... batchBytes) {
        return of(MAGIC, seed, batchBytes);
    }

    /** The same, and the last batch is a poster. */
    public static byte[] shown(long seed, int... batchBytes) {
        return of(MAGIC_WITH_POSTER, seed, batchBytes);
    }

    private static byte[] of(int magic, long seed, int... batchBytes) {
        int total = 0;
        for (int bytes : batchBytes) total += bytes;
        byte[] file = new byte[total];
        new Random(seed).nextBytes(file);
        ByteArrayOutputStream index = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(index)) {
            out.writeInt(magic);
            out.writeInt(batchBytes.length);
            for (int bytes : batchBytes) out.writeInt(bytes);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        if (index.size() > batchBytes[0]) throw new IllegalArgumentException("the first batch is too small");
        System.arraycopy(index.toByteArray(), 0, file, 0, index.size());
        return file;
    }

    private static ArchiveHeader header(Archive archive) throws IOException {
        byte[] start = archive.copy(0, (int) Math.min(archive.bytes(), 4096));
        BatchIndexBuilder index = new BatchIndexBuilder();
        try (DataInputStream in = new DataInputStream(new ByteArrayInputStream(start))) {
            int magic = in.readInt();
            if (magic != MAGIC && magic != MAGIC_WITH_POSTER) throw new MalformedStreamException(0, "no test archive");
            int batches = in.readInt();
            for (int i = 0; i < batches; i++) {
                boolean isPoster = magic == MAGIC_WITH_POSTER && i == batches - 1;
                BatchKind kind = i == 0 ? BatchKind.BASE : isPoster ? BatchKind.POSTER : BatchKind.SPLITS;
                index.add(kind, in.readInt(), i).after(100 * (i + 1), 50 * (i + 1), 1.0 / (i + 1));
            }
        } catch (MalformedStreamException e) {
            throw e;
        } catch (IOException e) {
            throw new MalformedStreamException(start.length, "the file ends within its index");
        }
        float[] bounds = {0, 0, 0, 1, 2, 3};
        return new ArchiveHeader(
                700,
                350,
                400,
                List.of(),
                List.of(),
                List.of(),
                List.of(),
                new double[3],
                bounds,
                UpAxis.UNKNOWN,
                false,
                List.of(),
                "ab".repeat(32),
                Provenance.NONE,
                index.build());
    }
}
