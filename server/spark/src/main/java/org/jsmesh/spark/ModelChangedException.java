package org.jsmesh.spark;

import org.jsmesh.objects.ObjectConflictException;

/** A model's file is not the one that was planned, so it may need other memory than what it was let in with. */
final class ModelChangedException extends Exception {
    private static final long serialVersionUID = 1;

    private final PlannedModel now;

    /** @param now the model as it has become */
    ModelChangedException(PlannedModel now, ObjectConflictException cause) {
        super(cause);
        this.now = now;
    }

    PlannedModel now() {
        return now;
    }
}
