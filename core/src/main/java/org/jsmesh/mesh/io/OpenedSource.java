package org.jsmesh.mesh.io;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.List;

/** Closes what was opened of a source, also where reading ends early. */
final class OpenedSource implements ByteSource {
    private final ByteSource source;
    private final List<InputStream> opened = new ArrayList<>();

    private OpenedSource(ByteSource source) {
        this.source = source;
    }

    /** A source in memory is as good as it is. */
    static ByteSource of(ByteSource source) {
        return source instanceof Held ? source : new OpenedSource(source);
    }

    @Override
    public long length() {
        return source.length();
    }

    @Override
    public InputStream from(long offset) throws IOException {
        InputStream in = new FilterInputStream(source.from(offset)) {
            @Override
            public void close() throws IOException {
                if (opened.remove(this)) super.close();
            }
        };
        opened.add(in);
        return in;
    }

    static void close(ByteSource source) throws IOException {
        if (!(source instanceof OpenedSource some)) return;
        for (InputStream in : List.copyOf(some.opened)) in.close();
    }
}
