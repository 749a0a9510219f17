package org.jsmesh.session;

import java.io.IOException;

/**
 * The archive at an address is no longer the one that the session began with, so its bytes cannot be joined. Open it
 * again.
 */
public final class ArchiveChangedException extends IOException {
    private static final long serialVersionUID = 1L;

    ArchiveChangedException(String url, String what) {
        super(url + ": the archive changed while it was being fetched (" + what
                + "); open it again to get the new one");
    }
}
