package org.jsmesh.objects;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;

/** The bytes of an object that is written. They can be read more than once, since a store may have to try again. */
public interface ObjectContent {
    /** {@return the number of bytes} */
    long bytes();

    /**
     * Reads from the first byte.
     *
     * @return exactly {@link #bytes()} bytes, to be closed
     * @throws IOException when they cannot be read
     */
    InputStream open() throws IOException;

    /**
     * Takes an array.
     *
     * @param content shared, not copied
     * @return its bytes
     */
    static ObjectContent of(byte[] content) {
        return new ObjectContent() {
            @Override
            public long bytes() {
                return content.length;
            }

            @Override
            public InputStream open() {
                return new ByteArrayInputStream(content);
            }
        };
    }

    /**
     * Takes a file.
     *
     * @param file that stays as it is while it is written
     * @return its bytes
     * @throws IOException when it cannot be looked at
     */
    static ObjectContent of(Path file) throws IOException {
        long bytes = Files.size(file);
        return new ObjectContent() {
            @Override
            public long bytes() {
                return bytes;
            }

            @Override
            public InputStream open() throws IOException {
                return Files.newInputStream(file);
            }
        };
    }
}
