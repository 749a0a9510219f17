package org.jsmesh.desktop.draw;

import java.util.function.BooleanSupplier;
import org.jsmesh.encode.measure.DistanceMeter;
import org.jsmesh.mesh.Mesh;

/**
 * How far each place of a mesh is from another one, as on the page: faces of coarse meshes are cut into smaller
 * triangles, because their corners may all lie on the finer one. Immutable.
 *
 * @param positions x, y, z of three corners per triangle, in the unit space of {@link Framing}
 * @param distances of the corners, in units of the model
 * @param farthest the largest of them
 */
public record ErrorMap(float[] positions, float[] distances, double farthest) {
    /** Triangles that a mesh of few faces is cut into, so that distances inside its faces show. */
    private static final int PIECES = 120_000;

    /** More pieces of one side of a face show nothing more. */
    private static final int MOST_CUTS = 48;

    /** Faces between two looks at whether the map is still wanted. */
    private static final int LOOK = 256;

    /**
     * Measures a mesh; large ones take seconds.
     *
     * @param mesh that is shown
     * @param newest measures from the mesh that it is compared with, such as the original
     * @param isStale asked now and then whether nobody wants the map any more
     * @return the map, or null when nobody wants it
     */
    public static ErrorMap of(Mesh mesh, DistanceMeter newest, Framing framing, BooleanSupplier isStale) {
        int cuts = cuts(mesh.faces());
        float[] positions = new float[9 * cuts * cuts * mesh.faces()];
        float[] distances = new float[positions.length / 3];
        CutFace cut = new CutFace(cuts);
        double farthest = 0;
        int corner = 0;
        for (int f = 0; f < mesh.faces(); f++) {
            if (f % LOOK == 0 && isStale.getAsBoolean()) return null;
            for (int k = 0; k < 3; k++)
                cut.corner(k, mesh.positions(), mesh.wedgeVertices()[mesh.faceWedges()[3 * f + k]]);
            float[] measured = newest.distances(cut.points());
            for (float distance : measured) farthest = Math.max(farthest, distance);
            corner = cut.write(measured, positions, distances, corner);
        }
        return new ErrorMap(framing.toUnit(positions), distances, farthest);
    }

    /** Into how many parts the sides of faces are cut. */
    static int cuts(int faces) {
        return (int) Math.max(1, Math.min(MOST_CUTS, Math.sqrt((double) PIECES / Math.max(1, faces))));
    }
}
