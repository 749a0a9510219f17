package org.jsmesh.encode.write;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.BatchIndexBuilder;
import org.jsmesh.archive.BatchKind;
import org.jsmesh.archive.coding.ArchiveLayout;
import org.jsmesh.archive.coding.IndexCoder;
import org.jsmesh.codec.MeshCoder;

/** The batches of an archive while it is written: their bytes, and their rows of the index. */
final class BatchList {
    final BatchIndexBuilder rows = new BatchIndexBuilder();
    final List<Payload> payloads = new ArrayList<>();
    private final MeshCoder coder;
    private final PrecisionSchedule precision;
    private long bytes; // of all payloads; the header is not known yet
    private int level;
    private int pass;

    /** @param coder tells what the mesh is after a batch */
    BatchList(MeshCoder coder, PrecisionSchedule precision) {
        this.coder = coder;
        this.precision = precision;
    }

    /** Sets level and pass of the batches to come. */
    void enter(int newLevel, int newPass) {
        level = newLevel;
        pass = newPass;
    }

    /** Bytes of all batches so far. */
    long bytes() {
        return bytes;
    }

    /** The most bytes that the next batch may have. */
    int cap() {
        return IndexCoder.cap(bytes);
    }

    int size() {
        return rows.size();
    }

    /** Adds the batch that was coded last. */
    void add(BatchKind kind, byte[] payload, int patches) {
        add(kind, payload, patches, coder.sweeps().precision());
    }

    /**
     * Adds a batch.
     *
     * @param coarsest shift of the coarsest positions after it
     */
    void add(BatchKind kind, byte[] payload, int patches, int coarsest) {
        add(kind, Payload.of(payload), patches, coarsest);
    }

    private void add(BatchKind kind, Payload payload, int patches, int coarsest) {
        rows.add(kind, payload.length(), patches)
                .after(coder.faces(), coder.vertices(), 0)
                .in(level, pass)
                .precise(coder.sweeps().precision(), precision.bits(coarsest));
        payloads.add(payload);
        bytes += payload.length();
    }

    /** Adds a batch of verbatim bytes, as many as there is room for, and returns where the next one starts. */
    int addPortion(BatchKind kind, byte[] all, int from) {
        return addBytes(kind, all, from, Math.min(all.length - from, cap() - ArchiveLayout.CRC_BYTES));
    }

    /** Adds a batch of bytes that are of use only together, however much room there is. */
    void addWhole(BatchKind kind, byte[] all) {
        addBytes(kind, all, 0, all.length);
    }

    private int addBytes(BatchKind kind, byte[] all, int from, int size) {
        add(kind, Payload.verbatim(all, from, size), 0, coder.sweeps().precision());
        return from + size;
    }
}
