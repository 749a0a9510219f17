package org.jsmesh.mesh.io;

import java.io.ByteArrayInputStream;
import java.io.InputStream;

/** Bytes that come in small portions, as if they were a file that is not in memory. */
final class PortionedSource implements ByteSource {
    private final byte[] content;
    private final int portion;

    PortionedSource(byte[] content, int portion) {
        this.content = content;
        this.portion = portion;
    }

    @Override
    public long length() {
        return content.length;
    }

    @Override
    public InputStream from(long offset) {
        return new ByteArrayInputStream(content, (int) offset, content.length - (int) offset) {
            @Override
            public synchronized int read(byte[] bytes, int at, int length) {
                return super.read(bytes, at, Math.min(length, portion));
            }
        };
    }
}
