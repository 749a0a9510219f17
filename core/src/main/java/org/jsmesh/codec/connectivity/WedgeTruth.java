package org.jsmesh.codec.connectivity;

import org.jsmesh.codec.lod.LodMesh;

/** Answers what the encoder knows of wedges and materials, by corners and faces of the {@link LodMesh}. */
public interface WedgeTruth {
    /** The original's wedge at a corner of a face of the base, or of a face that the last split made. */
    int wedge(int corner);

    /** The original's wedge of the removed vertex in face {@code i} of a patch's run, or −1. */
    int runWedge(int patch, int i);

    int material(int face);

    /** Is the LodMesh's wedge the original's? */
    boolean is(int wedge, int originalWedge);

    /** Notes that the original's wedge was coded as this wedge. */
    void number(int originalWedge, int wedge);
}
