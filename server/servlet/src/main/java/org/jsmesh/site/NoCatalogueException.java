package org.jsmesh.site;

import java.nio.file.FileSystemException;

/** An object is not what this program writes in its place. */
final class NoCatalogueException extends FileSystemException {
    private static final long serialVersionUID = 1;

    NoCatalogueException(String address, Throwable cause) {
        super(
                address,
                null,
                "is no page of a catalogue. Put the file back, or remove m/index.json and publish all models again");
        initCause(cause);
    }
}
