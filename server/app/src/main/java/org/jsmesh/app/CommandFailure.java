package org.jsmesh.app;

import org.jsmesh.files.Explanation;

/** A command failed for a reason that the user can understand; the message is one line: what, where, remedy. */
final class CommandFailure extends Exception {
    private static final long serialVersionUID = 1L;

    CommandFailure(String message) {
        super(message);
    }

    /** @param about the file or address that was being worked on, or null when the cause names it */
    CommandFailure(Object about, Exception cause) {
        super(Explanation.of(about, cause).toString(), cause);
    }
}
