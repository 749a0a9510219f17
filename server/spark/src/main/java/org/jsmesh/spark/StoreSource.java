package org.jsmesh.spark;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import org.jsmesh.mesh.io.ByteSource;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;

/** One version of an object, of which only a small part is in memory. */
final class StoreSource implements ByteSource {
    private static final int FIRST_PORTION = 1 << 16;
    private static final int LARGEST_PORTION = 8 << 20;

    private final ObjectStore store;
    private final StoredObject object;

    StoreSource(ObjectStore store, StoredObject object) {
        this.store = store;
        this.object = object;
    }

    @Override
    public long length() {
        return object.bytes();
    }

    @Override
    public InputStream from(long offset) {
        return new Portions(offset);
    }

    /** Asks for ever larger portions: who reads on for long has few to wait for. */
    private final class Portions extends InputStream {
        private ByteBuffer portion = ByteBuffer.allocate(0);
        private int size = FIRST_PORTION;
        private long next;

        Portions(long offset) {
            next = offset;
        }

        @Override
        public int read() throws IOException {
            return fill() ? portion.get() & 0xFF : -1;
        }

        @Override
        public int read(byte[] into, int offset, int length) throws IOException {
            if (length == 0) return 0;
            if (!fill()) return -1;
            int count = Math.min(length, portion.remaining());
            portion.get(into, offset, count);
            return count;
        }

        private boolean fill() throws IOException {
            if (portion.hasRemaining()) return true;
            int count = (int) Math.min(size, object.bytes() - next);
            if (count <= 0) return false;
            if (portion.capacity() < size) portion = ByteBuffer.allocate(size);
            portion.clear().limit(count);
            store.read(object, next, portion);
            portion.flip();
            next += count;
            size = Math.min(LARGEST_PORTION, 2 * size);
            return true;
        }
    }
}
