package org.jsmesh.spark;

import java.io.IOException;
import java.io.Serializable;
import org.jsmesh.mesh.ProgressListener;

/** What a task does with one model. */
@FunctionalInterface
interface ModelWork extends Serializable {
    /**
     * Encodes and publishes a model.
     *
     * @param model as it was planned
     * @param threads that may be used
     * @param progress may stop it
     * @return the row of the report; a model that cannot be encoded is one, too
     * @throws ModelChangedException when the file is not the one that was planned; it is admitted anew then
     * @throws IOException when the site cannot be written
     * @throws OutOfMemoryError when the heap is too small
     */
    Row encode(PlannedModel model, int threads, ProgressListener progress) throws IOException, ModelChangedException;
}
