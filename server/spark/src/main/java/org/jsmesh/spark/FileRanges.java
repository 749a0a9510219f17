package org.jsmesh.spark;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import org.jsmesh.memory.ByteRanges;
import org.jsmesh.memory.MemoryEstimate;
import org.jsmesh.objects.ObjectStores;

/** Parts of a listed file. The first bytes are read at once, and serve most questions. */
final class FileRanges implements ByteRanges {
    private static final int FEW = 4;

    private final ListedModel file;
    private final byte[] start;
    private final boolean isSparing;

    private FileRanges(ListedModel file, byte[] start, boolean isSparing) {
        this.file = file;
        this.start = start;
        this.isSparing = isSparing;
    }

    static FileRanges of(ListedModel file) throws IOException {
        byte[] start = read(file, 0, (int) Math.min(file.bytes(), MemoryEstimate.START_BYTES));
        return new FileRanges(file, start, ObjectStores.isRemote(file.store()));
    }

    /** {@return the same, with as many samples as if each were free} */
    FileRanges withAllSamples() {
        return new FileRanges(file, start, false);
    }

    /** {@return whether there are fewer samples than there could be} */
    boolean isSparing() {
        return isSparing;
    }

    @Override
    public int samples() {
        return isSparing ? FEW : ByteRanges.super.samples();
    }

    @Override
    public byte[] read(long from, int bytes) throws IOException {
        int count = (int) Math.max(0, Math.min(bytes, file.bytes() - from));
        if (from + count <= start.length) return Arrays.copyOfRange(start, (int) from, (int) from + count);
        return read(file, from, count);
    }

    private static byte[] read(ListedModel file, long from, int bytes) throws IOException {
        byte[] content = new byte[bytes];
        if (bytes > 0) Worker.store(file.store()).read(file.version(), from, ByteBuffer.wrap(content));
        return content;
    }
}
