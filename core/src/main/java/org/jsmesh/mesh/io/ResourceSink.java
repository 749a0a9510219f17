package org.jsmesh.mesh.io;

import java.io.IOException;
import java.io.OutputStream;

/** Where a writer puts the model file and those beside it. */
@FunctionalInterface
public interface ResourceSink {
    /**
     * Opens a file to be written.
     *
     * @param name of the file, with {@code /} before parts in sub-folders; never absolute, never with {@code ..}; each
     *     name is asked for once
     * @return a stream that the writer closes
     * @throws IOException when it cannot be made
     */
    OutputStream create(String name) throws IOException;
}
