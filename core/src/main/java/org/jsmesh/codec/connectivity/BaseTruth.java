package org.jsmesh.codec.connectivity;

/** What the encoder knows of the base mesh; faces and corners are the original's. */
interface BaseTruth {
    /** A face of a component that has not been coded. */
    int nextComponent();

    /** The face behind a coded edge, as 3 × face + corner at the edge's end, or −1 at a boundary. */
    int across(int gate);

    /** The coded vertex at a corner, or −1 when it is new. */
    int fanAt(int face, int corner);

    void numberFan(int face, int corner, int fan);

    /** Face {@code face} was coded with the given corner first. */
    void numberFace(int face, int firstCorner, int newFace);
}
