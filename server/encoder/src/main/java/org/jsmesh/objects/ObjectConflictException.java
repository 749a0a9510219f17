package org.jsmesh.objects;

import java.nio.file.FileSystemException;

/** Somebody else has written or removed an object, so that it is not what it was taken for. */
public final class ObjectConflictException extends FileSystemException {
    private static final long serialVersionUID = 1;

    /**
     * Tells which object.
     *
     * @param object its address
     * @param reason what was expected of it, and what to do
     */
    public ObjectConflictException(String object, String reason) {
        super(object, null, reason);
    }
}
