package org.jsmesh.collapse;

/**
 * Cost of moving a vertex onto one of its neighbours, computed from the present faces around it.
 *
 * <p>With n_f and A_f the unit normals and areas of those faces, Δ the move and d_f = n_f · Δ:
 *
 * <pre>
 *   cost = Σ A_f d_f² + ½ (Σ A_f d_f)² / Σ A_f + w_b Σ |e|² h² + 1e-7 w |Δ|²
 * </pre>
 *
 * The second term punishes moves that change the enclosed volume. The third runs over the feature edges e at the vertex
 * (sharp ones, and folds by degree) without the one moved along; h is the distance of the target from the line through
 * e. The last breaks ties in flat regions by length; w is the original area gathered in the vertex.
 *
 * <p>Nothing is remembered from earlier collapses: Lindstrom and Turk 1998, 'Fast and memory efficient polygonal
 * simplification'. The quadratic form itself is that of Garland and Heckbert 1997. Lengths are in diagonals of the
 * mesh. Not thread-safe.
 */
public final class MemorylessQuadric {
    /** w_b */
    private static final double FEATURE_WEIGHT = 0.2;

    private static final double LENGTH_WEIGHT = 1e-7;

    private double xx;
    private double xy;
    private double xz;
    private double yy;
    private double yz;
    private double zz;
    private double gx;
    private double gy;
    private double gz;
    private double area;

    /** Forgets all faces. */
    public void clear() {
        xx = xy = xz = yy = yz = zz = gx = gy = gz = area = 0;
    }

    /**
     * Adds a face by its normal, which is twice as long as the face's area.
     *
     * @param length of the normal, not 0
     */
    public void addFace(double nx, double ny, double nz, double length) {
        double w = 0.5 / length; // A n nᵀ = ½ |N| · N Nᵀ / |N|²
        double wx = w * nx;
        double wy = w * ny;
        xx += wx * nx;
        xy += wx * ny;
        xz += wx * nz;
        yy += wy * ny;
        yz += wy * nz;
        zz += w * nz * nz;
        gx += nx;
        gy += ny;
        gz += nz;
        area += 0.5 * length;
    }

    /** Sum of the areas. */
    public double area() {
        return area;
    }

    /**
     * Cost of the move (dx, dy, dz), without the term of the feature edges.
     *
     * @param gathered original area gathered in the vertex
     */
    public double cost(double dx, double dy, double dz, double gathered) {
        double form = dx * (xx * dx + 2 * (xy * dy + xz * dz)) + dy * (yy * dy + 2 * yz * dz) + zz * dz * dz;
        double volume = 0.5 * (gx * dx + gy * dy + gz * dz);
        double cost = Math.max(form, 0) + LENGTH_WEIGHT * gathered * (dx * dx + dy * dy + dz * dz);
        return area > 0 ? cost + 0.5 * volume * volume / area : cost;
    }

    /** Cost of leaving the feature edge e of the vertex by a move d along another edge: w_b |e|² h². */
    public static double featureCost(double ex, double ey, double ez, double dx, double dy, double dz) {
        // |e|² h² is the squared length of e × d
        double cx = ey * dz - ez * dy;
        double cy = ez * dx - ex * dz;
        double cz = ex * dy - ey * dx;
        return FEATURE_WEIGHT * (cx * cx + cy * cy + cz * cz);
    }
}
