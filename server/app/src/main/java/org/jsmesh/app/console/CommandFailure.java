package org.jsmesh.app.console;

import org.jsmesh.files.Explanation;

/** A command failed for a reason that the user can understand; the message is one line: what, where, remedy. */
public final class CommandFailure extends Exception {
    private static final long serialVersionUID = 1L;

    public CommandFailure(String message) {
        super(message);
    }

    /** @param about the file or address that was being worked on, or null when the cause names it */
    public CommandFailure(Object about, Exception cause) {
        super(Explanation.of(about, cause).toString(), cause);
    }
}
