package org.jsmesh.session;

import org.jsmesh.display.LiveStep;
import org.jsmesh.mesh.Mesh;

/**
 * What a step of refinement changes, for a listener that {@linkplain SessionListener#isLive follows} the mesh. Arrays
 * are shared, not copied.
 *
 * @param live the changes of the arrays to draw
 * @param newPlaces triangles of these arrays that are new
 * @param newLevels of each of them the level in which it came, 0 for the base
 * @param images a mesh with the images that can be shown now; null where they are those of the step before
 * @param isLast whether all of the archive has arrived
 * @param progress how far the session was then
 * @param taken to be called, by any thread, when the next step may come. The end of a round does not wait for that
 */
public record MeshStep(
        LiveStep live,
        int[] newPlaces,
        byte[] newLevels,
        Mesh images,
        boolean isLast,
        SessionProgress progress,
        Runnable taken) {}
